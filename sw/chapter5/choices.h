// What chapter 5 of the thesis leaves open when a ray meets a surface made of voxels.
#pragma once

#include <string>
#include <vector>

namespace rc2::chapter5 {

/// By which normal the ray is reflected (5.2, 5.5.3).
enum class Normal {
  facet,  ///< of the voxel's owner (5.2.1)
  mean,   ///< the mean of all facets that fill the voxel (5.5.3)
  side    ///< of the side through which the ray came into the voxel (5.2.2)
};

/// Where the ray meets the surface, and the reflected one starts (5.3).
enum class Point {
  plane,   ///< on the owner's plane (5.3.3)
  centre,  ///< in the voxel's centre (5.3.2)
  side     ///< where the ray came into the voxel (5.3.1)
};

/// What lets a ray leave the surface that it starts from (5.5.2): the voxels that do not stop it.
enum class Leave {
  nothing,     ///< only that in which it starts
  own_facet,   ///< those of the owner of the voxel in which it starts
  gap,         ///< all until it has come to a free voxel
  facing,      ///< those whose owner it does not see from its front
  facing_exit  ///< also those whose plane it has not reached when it leaves them: the machine's
};

/// Who owns a voxel that several facets fill (5.5.3).
enum class Owner {
  core,     ///< a facet whose border holds its centre, then the nearest: the machine's
  nearest,  ///< the facet whose plane is nearest to its centre
  first     ///< the lowest number
};

/// From a voxel to the next.
enum class Steps {
  six,        ///< through sides: the machine's
  twenty_six  ///< also across edges and corners: the light's digital ray (4.3.1)
};

struct Choices {
  Normal normal = Normal::facet;
  Point point = Point::plane;
  Leave leave = Leave::facing_exit;
  Owner owner = Owner::core;
  Steps steps = Steps::six;
};

struct NamedChoices {
  std::string name;
  Choices choices;
};

/// The machine's choices, then each other choice alone, then what goes together in the thesis.
std::vector<NamedChoices> all_choices();

}  // namespace rc2::chapter5
