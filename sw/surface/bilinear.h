// Bi-linear approximation (thesis 3.2): the screen's way of filling polygons, kept to show why a
// set of voxels needs another.
//
// The polygon is scanned line by line from its highest corner down. Both ends of a line follow from
// the sides' slopes Dx/Dy and Dz/Dy; between them z is interpolated along x and rounded to the
// nearest integer, so each (x,y) gets one z, however steep the facet is.
//
// The thesis has no program for it. What it leaves open, and what is done here: corners are voxels
// (outline.h); an end is in the column nearest to it and has there the z of the end, not that of
// the plane; a line of one column takes the z of its left end, and of ends above one another that
// of the lower; a horizontal facet is one line, from its leftmost corner to its rightmost.
#pragma once

#include "sw/facet/polygon.h"
#include "sw/surface/voxel_array.h"

namespace rc2::surface {

/// Adds the facet's voxels. The border is planar and convex, in whole voxels within the array.
void fill_bilinear(const facet::Border& border, VoxelSet& voxels);

}  // namespace rc2::surface
