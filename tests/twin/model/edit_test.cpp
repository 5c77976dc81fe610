// Edits of the text of a model file change one section and no other byte.
#include <gtest/gtest.h>

#include "twin/effects/catalogue.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

EffectSetting coulomb(double friction, std::optional<Joint> joint = {}) {
  return {findEffect("coulomb"), {friction}, joint};
}

const std::string kPlain =
    "; my robot\n\n[model]\nname = test   ; two legs\n\n"
    "[effect viscous]\ndamping = 0.01 N m s/rad\n; not sure\n\n"
    "; of the body\n[body]\nstep = 0.001 s\n";

TEST(WithEffect, AddsLinesBelowTheOtherEffectsAndNothingElse) {
  EXPECT_EQ(withEffect(kPlain, coulomb(0.03), {"found in three logs", "0.03 +- 0.004 N m"}),
            "; my robot\n\n[model]\nname = test   ; two legs\n\n"
            "[effect viscous]\ndamping = 0.01 N m s/rad\n; not sure\n"
            "\n; found in three logs\n; 0.03 +- 0.004 N m\n[effect coulomb]\nfriction = 0.03 N m\n"
            "\n; of the body\n[body]\nstep = 0.001 s\n");
}

TEST(WithEffect, AddsAtTheEndWhereThereIsNoEffectYet) {
  EXPECT_EQ(withEffect(kNamed, coulomb(0.03), {}), kNamed + "\n[effect coulomb]\nfriction = 0.03 N m\n");
  EXPECT_EQ(withEffect("[model]\nname = test", coulomb(0.03), {}),
            kNamed + "\n[effect coulomb]\nfriction = 0.03 N m\n");
}

TEST(WithEffect, OfOneJointIsAddedToTheCommonOne) {
  const std::string text = withEffect(withEffect(kPlain, coulomb(0.03), {}), coulomb(0.05, Joint::kNeck), {});
  const Model model = parseModel(text, "my.ini");
  ASSERT_EQ(model.effects.size(), 3U);
  EXPECT_EQ(model.effects[1].values[0], 0.03);
  EXPECT_EQ(model.effects[2].values[0], 0.05);
}

TEST(WithEffect, ReplacesTheSectionAndItsCommentsInPlace) {
  const std::string before = "; head of the file\n\n[model]\nname = test\n";
  const std::string after = "\n; on the floor\n[body]\nstep = 0.001 s\n";
  const std::string old = "\n; thesis\n[effect coulomb]\nfriction = 0.025 N m  ; of 2013\n; end\n";
  EXPECT_EQ(withEffect(before + old + after, coulomb(0.03), {"measured"}),
            before + "\n; measured\n[effect coulomb]\nfriction = 0.03 N m\n" + after);
}

TEST(WithEffect, KeepsACommentDirectlyAboveTheNextSection) {
  const std::string text = kNamed + "[effect coulomb]\nfriction = 0.1 N m\n; on the floor\n[body]\n";
  EXPECT_EQ(withEffect(text, coulomb(0.2), {}),
            kNamed + "[effect coulomb]\nfriction = 0.2 N m\n; on the floor\n[body]\n");
  EXPECT_EQ(withoutEffect(text, "coulomb", {}), kNamed + "; on the floor\n[body]\n");
}

TEST(WithEffect, KeepsTheLineEndsOfTheFileItsMarkAndItsUnfinishedLastLine) {
  const std::string text = "\xEF\xBB\xBF[model]\r\nname = test\r\n\r\n[effect coulomb]\r\nfriction = 0.1 N m";
  EXPECT_EQ(withEffect(text, coulomb(0.2), {"new"}),
            "\xEF\xBB\xBF[model]\r\nname = test\r\n\r\n; new\r\n[effect coulomb]\r\nfriction = 0.2 N m");
}

TEST(WithEffect, MakesOneCommentLineOfEachLineOfAComment) {
  EXPECT_EQ(withEffect(kNamed, coulomb(0.03), {"two\nlines", "", "friction = 9 N m"}),
            kNamed + "\n; two\n; lines\n;\n; friction = 9 N m\n[effect coulomb]\nfriction = 0.03 N m\n");
}

TEST(WithEffect, RefusesAValueOutOfRange) {
  EXPECT_EQ(
      refusal([] { withEffect(kNamed, coulomb(7), {}); }),
      std::string{"the model, line 5: [effect coulomb] friction = 7 N m: "} + messages::kOutOfRange + "0 to 4 N m");
  EXPECT_EQ(refusal([] { withEffect(kNamed, {findEffect("coulomb"), {}, {}}, {}); }), messages::kValuesMissing);
}

TEST(WithEffect, RefusesAnInvalidModel) {
  EXPECT_EQ(refusal([] { withEffect(kNamed + "[servo]\nkt = 1\n", coulomb(0.1), {}); }),
            "the model, line 4: [servo] kt = 1: the unit is missing; write 1 N m/A");
}

TEST(WithoutEffect, RemovesWhatWithEffectAdded) {
  EXPECT_EQ(withoutEffect(withEffect(kPlain, coulomb(0.03), {"found"}), "coulomb", {}), kPlain);
  EXPECT_EQ(withoutEffect(withEffect(kPlain, coulomb(0.03, Joint::kHead), {}), "COULOMB", Joint::kHead), kPlain);
}

TEST(WithoutEffect, RefusesAMissingSection) {
  EXPECT_EQ(refusal([] { withoutEffect(kPlain, "viscous", Joint::kNeck); }),
            "the model has no section [effect viscous Neck] to remove");
  EXPECT_EQ(refusal([] { withoutEffect(kPlain, "viscos", {}); }),
            "there is no effect \"viscos\"; did you mean viscous?");
}

}  // namespace
}  // namespace darwinop::twin
