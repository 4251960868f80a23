# SPDX-License-Identifier: GPL-2.0-or-later
# What an engineer does who adds a formula: a theorem in a chapter, a row in the table of forms; nothing else. Here two
# rows: another form of the angle, and a form of a new quantity. Writes
# rotation.cpp and forms.cpp with these edits into OUT.
#   cmake -D SYMBOLIC=symbolic -D OUT=FOLDER -P plant.cmake
function(plant file anchor text)
  file(READ ${SYMBOLIC}/${file} source)
  string(FIND "${source}" "${anchor}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "${file} has no longer the line before which a formula is planted: ${anchor}")
  endif()
  string(REPLACE "${anchor}" "${text}${anchor}" source "${source}")
  get_filename_component(name ${file} NAME)
  file(WRITE ${OUT}/${name} "${source}")
endfunction()

plant(derivation/rotation.cpp "  return {frame, psi, psi_half_angle" [[
  kernel.equal_angles({.id = "rotation.psi_planted",
                       .statement = {psi.lhs(), 2 * atan(sqrt(alpha) * sqrt(2 + alpha))},
                       .words = "one root for each factor"});
]])
plant(codegen/forms.cpp "      {.quantity = \"angle\",\n       .name = \"closed\"" [[
      {.quantity = "angle",
       .name = "planted",
       .summary = "The angle psi of one cycle, with a root for each factor",
       .domain = "alpha > 0 and finite",
       .real_input = "alpha",
       .outputs = {{"psi", "rotation.psi_planted"}}},
      {.quantity = "half_turn",
       .name = "planted",
       .summary = "A quantity that nobody knows: the cosine of half of psi",
       .domain = "alpha > 0 and finite",
       .real_input = "alpha",
       .outputs = {{"cosine", "rotation.cos_half_psi"}}},
]])
