#include "bentur/contact/axial_stiffness.h"

#include "bentur/core/require.h"

namespace bentur {

double half_beam_stiffness(double elastic_modulus, double area, double bay_width) {
  require_positive("elastic_modulus", elastic_modulus);
  require_positive("area", area);
  require_positive("bay_width", bay_width);
  return elastic_modulus * area / (bay_width / 2);
}

double series_stiffness(double first, double second) {
  require_positive("first stiffness", first);
  require_positive("second stiffness", second);
  return 1 / (1 / first + 1 / second);
}

}  // namespace bentur
