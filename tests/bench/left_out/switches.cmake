# Leaves parts of the system out of a build, to count what they cost where they are there and off
# (tests/bench/left_out.md). Given to cmake, for the top level of the project, as
#   -DCMAKE_PROJECT_displayfile_INCLUDE=tests/bench/left_out/switches.cmake -DDISPLAYFILE_LEFT_OUT=PART,PART...
#
# A part is left out where its switch is declared: copies of the headers in the build folder, which
# come before the project's own, declare there that it is always off, and the compiler does the rest.
set(overlay ${CMAKE_BINARY_DIR}/left_out)
file(REMOVE_RECURSE ${overlay})
configure_file(${CMAKE_CURRENT_LIST_DIR}/part.h.in ${overlay}/clip/part.h @ONLY)

# In the header's copy, the declaration is replaced, which must be there once.
function(switch header declaration replacement)
  if(EXISTS ${overlay}/${header})
    file(READ ${overlay}/${header} text)
  else()
    file(READ ${PROJECT_SOURCE_DIR}/${header} text)
    string(REPLACE "#pragma once\n" "#pragma once\n\n#include \"clip/part.h\"\n" text "${text}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
  endif()
  string(REPLACE "${declaration}" "${replacement}" replaced "${text}")
  string(REPLACE "${declaration}" "" without "${text}")
  string(LENGTH "${text}" before)
  string(LENGTH "${without}" after)
  string(LENGTH "${declaration}" once)
  math(EXPR gone "${before} - ${after}")
  if(NOT gone EQUAL once)
    message(FATAL_ERROR "${header}: expected once: ${declaration}")
  endif()
  file(WRITE ${overlay}/${header} "${replaced}")
endfunction()

switch(clip/view/transformation.h "return identity_;"
       "return is_left_out(PartLeftOut::modelling) || identity_;")
switch(clip/view/transformation.h "return scale == Point2(1.0, 1.0)"
       "if (is_left_out(PartLeftOut::image_transformation)) return true;\n    return scale == Point2(1.0, 1.0)")
switch(clip/base/budgeted_work.h "if (--left_ == 0) ask();"
       "if (!is_left_out(PartLeftOut::budgets) && --left_ == 0) ask();")
switch(clip/base/budgeted_work.h "if (steps >= left_)"
       "if (is_left_out(PartLeftOut::budgets)) return;\n    if (steps >= left_)")
switch(clip/base/budgeted_work.h "if (const WorkBudget* const budget = work_in_force().budget) {"
       "if (is_left_out(PartLeftOut::budgets)) return;
        if (const WorkBudget* const budget = work_in_force().budget) {")
switch(displayfile/looks/style.h "std::optional<Light> light;"
       "Switch<PartLeftOut::light, std::optional<Light>> light;")
switch(displayfile/looks/style.h "bool back_face_removal ="
       "Switch<PartLeftOut::back_face_removal, bool> back_face_removal =")
switch(displayfile/looks/style.h "bool shadows ="
       "Switch<PartLeftOut::shadows, bool> shadows =")
switch(displayfile/user_routines/system_state.h "Recorder* recorder_ ="
       "Switch<PartLeftOut::recording, Recorder*> recorder_ =")
switch(displayfile/user_routines/system_state.h "RetainedScene* retaining() { return own_retained_ ?"
       "RetainedScene* retaining() { return is_left_out(PartLeftOut::retaining) ? nullptr :
                                        own_retained_ ?")
switch(displayfile/looks/style.h "Shading shading ="
       "Switch<PartLeftOut::shading, Shading> shading =")
switch(displayfile/entered/instructions.h "return has_shadows_;"
       "return !is_left_out(PartLeftOut::shadows) && has_shadows_;")
switch(displayfile/entered/instructions.h "return !texts_.empty();"
       "return !is_left_out(PartLeftOut::texts) && !texts_.empty();")
switch(displayfile/looks/style.h "std::optional<FillShadow> shadow{};"
       "Switch<PartLeftOut::shadows, std::optional<FillShadow>> shadow{};")
switch(displayfile/looks/style.h "enum class Kind { solid, dashed, none };\n  Kind kind ="
       "enum class Kind { solid, dashed, none };\n  Switch<PartLeftOut::lines, Kind, Kind::none> kind =")
switch(displayfile/looks/world_polygon.h "std::span<const Point3> vertex_normals; "
       "Switch<PartLeftOut::shading, std::span<const Point3>> vertex_normals; ")
switch(interp/draw/picture_plan.h "int samples = 1; "
       "Switch<PartLeftOut::antialiasing, int, 1> samples = 1; ")
switch(interp/device/raster_request.h "bool ids = false, depth = false;"
       "Switch<PartLeftOut::item_buffer, bool> ids = false;\n  Switch<PartLeftOut::depths, bool> depth = false;")
switch(interp/device/raster_request.h "bool texts = true;" "Switch<PartLeftOut::texts, bool> texts = true;")

include_directories(BEFORE ${overlay})
