#pragma once

#include <cstddef>
#include <cstdint>

#include "programs/scenes/scene.h"

namespace displayfile {

// The generators of the hard cases, by file. hard_cases.cpp says what each makes, and what its
// size and severity mean.

// coplanar_families.cpp: polygons that lie in one plane
Scene coplanar_copies(std::size_t n, double severity, std::uint64_t seed);
Scene coplanar_turned(std::size_t n, double severity, std::uint64_t seed);
Scene coplanar_patches(std::size_t n, double severity, std::uint64_t seed);
Scene coplanar_rounded(std::size_t n, double severity, std::uint64_t seed);
Scene coplanar_entry_orders(std::size_t n, double severity, std::uint64_t seed);
Scene checker_over_base(std::size_t n, double severity, std::uint64_t seed);
Scene decals(std::size_t n, double severity, std::uint64_t seed);
Scene coplanar_fan_over_polygon(std::size_t n, double severity, std::uint64_t seed);

// gap_families.cpp: a gap that shrinks
Scene parallel_sheets(std::size_t n, double severity, std::uint64_t seed);
Scene nearly_coplanar(std::size_t n, double severity, std::uint64_t seed);
Scene shallow_crossing(std::size_t n, double severity, std::uint64_t seed);
Scene saw(std::size_t n, double severity, std::uint64_t seed);
Scene thin_plates(std::size_t n, double severity, std::uint64_t seed);
Scene poking_corners(std::size_t n, double severity, std::uint64_t seed);
Scene hinged_pages(std::size_t n, double severity, std::uint64_t seed);
Scene shingles(std::size_t n, double severity, std::uint64_t seed);
Scene ulp_stack(std::size_t n, double severity, std::uint64_t seed);
Scene ulp_stack_tilted(std::size_t n, double severity, std::uint64_t seed);
Scene ulp_interleaved(std::size_t n, double severity, std::uint64_t seed);

// cycle_families.cpp: cyclic overlap
Scene cycle(std::size_t n, double severity, std::uint64_t seed);
Scene every_cycle(std::size_t n, double severity, std::uint64_t seed);
Scene nested_cycles(std::size_t n, double severity, std::uint64_t seed);
Scene piercing_cycle(std::size_t n, double severity, std::uint64_t seed);
Scene weave(std::size_t n, double severity, std::uint64_t seed);
Scene mikado(std::size_t n, double severity, std::uint64_t seed);

// crossing_families.cpp: polygons that pass through each other
Scene interpenetrating(std::size_t n, double severity, std::uint64_t seed);
Scene crossing_grid(std::size_t n, double severity, std::uint64_t seed);
Scene pencil_of_planes(std::size_t n, double severity, std::uint64_t seed);
Scene oblique_pencil(std::size_t n, double severity, std::uint64_t seed);
Scene bundle_of_planes(std::size_t n, double severity, std::uint64_t seed);
Scene crossing_at_centres(std::size_t n, double severity, std::uint64_t seed);
Scene undecided_at_one_pixel(std::size_t n, double severity, std::uint64_t seed);
Scene equal_depth_lines(std::size_t n, double severity, std::uint64_t seed);
Scene piercing_needles(std::size_t n, double severity, std::uint64_t seed);
Scene crossing_boxes(std::size_t n, double severity, std::uint64_t seed);
Scene interlocked_links(std::size_t n, double severity, std::uint64_t seed);
Scene moebius_strip(std::size_t n, double severity, std::uint64_t seed);
Scene self_crossing_surface(std::size_t n, double severity, std::uint64_t seed);

// touching_families.cpp: shared edges and vertices
Scene t_junctions(std::size_t n, double severity, std::uint64_t seed);
Scene shared_edges(std::size_t n, double severity, std::uint64_t seed);
Scene tiles_on_centres(std::size_t n, double severity, std::uint64_t seed);
Scene fan_of_needles(std::size_t n, double severity, std::uint64_t seed);
Scene vertex_on_plane(std::size_t n, double severity, std::uint64_t seed);
Scene touching_points(std::size_t n, double severity, std::uint64_t seed);
Scene touching_edges(std::size_t n, double severity, std::uint64_t seed);
Scene nested_boxes(std::size_t n, double severity, std::uint64_t seed);
Scene stacked_cubes(std::size_t n, double severity, std::uint64_t seed);
Scene folded_paper(std::size_t n, double severity, std::uint64_t seed);
Scene quads_rounded_off_plane(std::size_t n, double severity, std::uint64_t seed);

// coverage_families.cpp: which centres are covered
Scene edges_through_centres(std::size_t n, double severity, std::uint64_t seed);
Scene vertices_at_centres(std::size_t n, double severity, std::uint64_t seed);
Scene edges_on_rows(std::size_t n, double severity, std::uint64_t seed);
Scene ulp_off_centres(std::size_t n, double severity, std::uint64_t seed);
Scene edges_past_centres(std::size_t n, double severity, std::uint64_t seed);
Scene pixel_sized(std::size_t n, double severity, std::uint64_t seed);
Scene subpixel(std::size_t n, double severity, std::uint64_t seed);
Scene slivers(std::size_t n, double severity, std::uint64_t seed);
Scene crossing_needles(std::size_t n, double severity, std::uint64_t seed);
Scene edge_on(std::size_t n, double severity, std::uint64_t seed);
Scene nearly_edge_on(std::size_t n, double severity, std::uint64_t seed);
Scene ill_conditioned_planes(std::size_t n, double severity, std::uint64_t seed);
Scene steep_planes(std::size_t n, double severity, std::uint64_t seed);

// shape_families.cpp: no simple convex shapes
Scene repeated_vertices(std::size_t n, double severity, std::uint64_t seed);
Scene first_three_in_line(std::size_t n, double severity, std::uint64_t seed);
Scene zero_area(std::size_t n, double severity, std::uint64_t seed);
Scene spikes(std::size_t n, double severity, std::uint64_t seed);
Scene concave(std::size_t n, double severity, std::uint64_t seed);
Scene combs(std::size_t n, double severity, std::uint64_t seed);
Scene spirals(std::size_t n, double severity, std::uint64_t seed);
Scene crossing_stars(std::size_t n, double severity, std::uint64_t seed);
Scene self_crossing(std::size_t n, double severity, std::uint64_t seed);
Scene holes(std::size_t n, double severity, std::uint64_t seed);
Scene run_through_twice(std::size_t n, double severity, std::uint64_t seed);
Scene many_sides(std::size_t n, double severity, std::uint64_t seed);
Scene not_flat(std::size_t n, double severity, std::uint64_t seed);
Scene bent_within_tolerance(std::size_t n, double severity, std::uint64_t seed);
Scene picket_fence(std::size_t n, double severity, std::uint64_t seed);

// scale_families.cpp: coordinates of unlike sizes
Scene offset_world(std::size_t n, double severity, std::uint64_t seed);
Scene offset_depth(std::size_t n, double severity, std::uint64_t seed);
Scene extreme_depth_range(std::size_t n, double severity, std::uint64_t seed);
Scene deep_background(std::size_t n, double severity, std::uint64_t seed);
Scene subnormal_depths(std::size_t n, double severity, std::uint64_t seed);
Scene tiny_coordinates(std::size_t n, double severity, std::uint64_t seed);
Scene shrunken_images(std::size_t n, double severity, std::uint64_t seed);
Scene giant_images(std::size_t n, double severity, std::uint64_t seed);
Scene giant_clipped(std::size_t n, double severity, std::uint64_t seed);
Scene rotated_images(std::size_t n, double severity, std::uint64_t seed);
Scene collapsed_images(std::size_t n, double severity, std::uint64_t seed);
Scene near_front_plane(std::size_t n, double severity, std::uint64_t seed);
Scene ground_to_horizon(std::size_t n, double severity, std::uint64_t seed);
Scene decals_in_perspective(std::size_t n, double severity, std::uint64_t seed);
Scene behind_the_viewer(std::size_t n, double severity, std::uint64_t seed);
Scene oblique_view(std::size_t n, double severity, std::uint64_t seed);

}  // namespace displayfile
