// Horizontal slices (thesis 3.3): a facet is cut at every line Y = const, and the piece between
// line Y + 1 and line Y, seen from above, is a quadrilateral whose columns are filled in z.
//
// This is the printed program with exact fractions in place of its running sums. Its corners are
// voxels (outline.h). The print does not end, divides by zero or fills next to nothing in the cases
// below; the method is unharmed by them, so they are mended:
//  - a horizontal facet (the search for s1 never ends) is one slice, its own border;
//  - a column is filled from the voxel nearest to z1 to that nearest to z2 (the print counts to
//    Nbs - 1, the number of the facet's corners; Nbp, the nearest to z2 - z1, is left unused and
//    could be one off);
//  - a slice of one column is filled over the whole range of z of its corners (the print draws one
//    voxel);
//  - at a corner where several meet, as at every triangle's tip, the search for the next side goes
//    on to a corner in another column (the print divides by zero);
//  - the first slopes are lost in the print; they are those of the update further down.
// Kept as printed: a corner is rounded before the quadrilateral is filled, and the slice between
// two lines goes to the lower one, so the surface lies half a voxel too low.
#pragma once

#include "sw/facet/polygon.h"
#include "sw/surface/voxel_array.h"

namespace rc2::surface {

/// Adds the facet's voxels. The border is planar and convex, in whole voxels within the array.
void fill_slices(const facet::Border& border, VoxelSet& voxels);

}  // namespace rc2::surface
