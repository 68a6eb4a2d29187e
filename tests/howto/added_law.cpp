// The law that docs/howto/add_contact_law.md gives to copy compiles and is the law that it says it is.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bentur/contact/laws/hardening_spring.h"
#include "bentur/core/errors.h"

namespace bentur {
namespace {

TEST(ContactLawTemplate, IsTheLawItSays) {
  const HardeningSpring law(3, 2);
  LawState touching;
  touching.branch = 1;
  EXPECT_EQ(law.force({}, -0.5, 1), 0);
  EXPECT_DOUBLE_EQ(law.force(touching, 0.5, -1), 3 * 0.5 + 2 * 0.125);
  EXPECT_DOUBLE_EQ(law.stored_energy(touching, 0.5), 3 * 0.25 / 2 + 2 * 0.0625 / 4);
  EXPECT_TRUE(std::isnan(law.force(touching, 0.5, std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(law.branch({}).bodies, Bodies::apart);
  EXPECT_EQ(law.branch(touching).guards[0].deformation, 1);
  EXPECT_EQ(HardeningSpring::entry().name, law.name());
  EXPECT_THROW(HardeningSpring(0, 1), InvalidParameter);
  EXPECT_THROW(HardeningSpring(1, -1), InvalidParameter);
}

}  // namespace
}  // namespace bentur
