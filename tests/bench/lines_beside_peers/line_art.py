"""Times Blender's Line Art on a mesh in a view, and writes its strokes. A peer of
lines-beside-peers (README.md here has the protocol):

    blender -b -t THREADS --factory-startup --python line_art.py -- MESH.obj VIEW KINDS OPTIONS

KINDS are outline, crease, all and intersection, joined by commas. OPTIONS, which may be empty, set
properties of the modifier: NAME=VALUE, joined by commas.
"""

import array
import math
import sys
import time

import bpy
import mathutils

CREASE_DEGREES = 30.0  # between the faces' normals; Blender counts the angle between the faces
IMAGE_SIZE = 1024
NEAR_MARGIN = 0.9  # of the nearest vertex' distance
FAR_MARGIN = 1.1


def read_mesh(path):
    vertices, faces = [], []
    with open(path) as lines:
        for line in lines:
            words = line.split()
            if words and words[0] == "v":
                vertices.append([float(w) for w in words[1:4]])
            elif words and words[0] == "f":
                faces.append([int(w) - 1 for w in words[1:]])
    return vertices, faces


def read_view(path):
    with open(path) as lines:
        return {w[0]: [float(x) for x in w[1:]] for w in map(str.split, lines) if w}


def enter_mesh(vertices, faces, all_edges):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(vertices, [], faces)
    mesh.validate()
    mesh.update()
    if all_edges:
        for edge in mesh.edges:
            edge.use_freestyle_mark = True
    entered = bpy.data.objects.new("mesh", mesh)
    bpy.context.scene.collection.objects.link(entered)
    return entered


def enter_camera(view, vertices):
    right, up, back = (mathutils.Vector(view[k]) for k in ("right", "up", "toward"))
    x_min, x_max, y_min, y_max = view["window"]
    width = x_max - x_min
    origin = mathutils.Vector(view["origin"])
    data = bpy.data.cameras.new("camera")
    heights = [(mathutils.Vector(v) - origin).dot(back) for v in vertices]
    eye_x, eye_y, eye_z = view["eye"]
    if view["perspective"][0]:
        data.type = "PERSP"
        data.sensor_fit = "HORIZONTAL"
        data.angle = 2.0 * math.atan(0.5 * width / eye_z)
    else:
        data.type = "ORTHO"
        data.ortho_scale = width
        eye_x, eye_y = 0.5 * (x_min + x_max), 0.5 * (y_min + y_max)
        eye_z = max(heights) + width
    data.shift_x = (0.5 * (x_min + x_max) - eye_x) / width
    data.shift_y = (0.5 * (y_min + y_max) - eye_y) / width
    data.clip_start = NEAR_MARGIN * (eye_z - max(heights))
    data.clip_end = FAR_MARGIN * (eye_z - min(heights))
    at = origin + eye_x * right + eye_y * up + eye_z * back
    camera = bpy.data.objects.new("camera", data)
    camera.matrix_world = mathutils.Matrix(
        [[right[i], up[i], back[i], at[i]] for i in range(3)] + [[0.0, 0.0, 0.0, 1.0]]
    )
    scene = bpy.context.scene
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x = scene.render.resolution_y = IMAGE_SIZE
    scene.render.resolution_percentage = 100


def enter_line_art(mesh, kinds, options):
    data = bpy.data.grease_pencils.new("lines")
    material = bpy.data.materials.new("lines")
    bpy.data.materials.create_gpencil_data(material)
    data.materials.append(material)
    layer = data.layers.new("lines")
    layer.frames.new(bpy.context.scene.frame_current)
    lines = bpy.data.objects.new("lines", data)
    bpy.context.scene.collection.objects.link(lines)
    art = lines.grease_pencil_modifiers.new("lines", "GP_LINEART")
    art.source_type = "OBJECT"
    art.source_object = mesh
    art.target_layer = layer.info
    art.target_material = material
    # An edge has one type: that of a boundary or an outline is never a mark.
    art.use_contour = "outline" in kinds or "all" in kinds
    art.use_crease = "crease" in kinds
    art.crease_threshold = math.radians(180.0 - CREASE_DEGREES)
    art.use_edge_mark = "all" in kinds
    art.use_intersection = "intersection" in kinds
    art.use_loose = art.use_material = False
    art.use_multiple_levels = False
    art.level_start = 0
    # Strokes stay where the edges are, and keep their points.
    art.stroke_depth_offset = 0.0
    art.smooth_tolerance = 0.0
    art.split_angle = 0.0
    art.chaining_image_threshold = 0.0
    for option in filter(None, options.split(",")):
        name, value = option.split("=")
        setattr(art, name, type(getattr(art, name))(float(value)))
    return lines, layer.info


def evaluate(lines):
    """Has the modifier evaluated, and nothing else: the mesh is as it was."""
    lines.update_tag(refresh={"DATA"})
    graph = bpy.context.evaluated_depsgraph_get()
    graph.update()
    return graph


def segments(graph, lines, layer):
    """The ends of the strokes' segments, in world coordinates."""
    ends = array.array("d")
    for frame in lines.evaluated_get(graph).data.layers[layer].frames:
        for stroke in frame.strokes:
            points = array.array("f", bytes(12 * len(stroke.points)))
            stroke.points.foreach_get("co", points)
            points = points.tolist()
            for i in range(3, len(points), 3):
                ends.extend(points[i - 3 : i + 3])
            if stroke.use_cyclic:
                ends.extend(points[-3:])
                ends.extend(points[:3])
    return ends


def answer(words):
    print("peer:", words, flush=True)


def main():
    mesh_path, view_path, kinds, options = sys.argv[sys.argv.index("--") + 1 :]
    kinds = kinds.split(",")
    for name in list(bpy.data.objects):
        bpy.data.objects.remove(name)
    vertices, faces = read_mesh(mesh_path)
    mesh = enter_mesh(vertices, faces, "all" in kinds)
    enter_camera(read_view(view_path), vertices)
    lines, layer = enter_line_art(mesh, kinds, options)
    evaluate(lines)
    answer("ready")
    for line in sys.stdin:
        words = line.split()
        if words[0] == "round":
            clock = time.process_time if words[1] == "processor" else time.perf_counter
            start = clock()
            evaluate(lines)
            answer(f"seconds {clock() - start}")
        elif words[0] == "segments":
            ends = segments(evaluate(lines), lines, layer)
            with open(words[1], "wb") as file:
                ends.tofile(file)
            answer(f"segments {len(ends) // 6}")


try:
    main()
except Exception as error:  # the process would go on without us
    answer(f"failed {error!r}")
