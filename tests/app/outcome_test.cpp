// SPDX-License-Identifier: MIT
#include "apps/evenmesh/outcome.h"

#include <gtest/gtest.h>

#include "evenmesh/constraint/keep.h"
#include "tests/app/patch_stub.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

const ActiveCell kMetCell{0, 1.0, 0.0};
const ActiveCell kUnmetCell{0, 1.0, 0.5};
const ActiveBound kMet{4, 1.0, 0.0};
const ActiveBound kUnmet{4, 1.0, 0.25};

TEST(Demands, CountWhereTheyWereMade) {
  const Holding cells{{}, {kMetCell, kUnmetCell}, {}, {}};
  const Holding moves{{}, {}, {kMet, kUnmet}, {}};
  const Holding bounds{{}, {}, {}, {kMet, kUnmet}};
  for (const ConstraintText& asked :
       {ConstraintText{.min_area = "1"}, ConstraintText{.min_volume = "1"},
        ConstraintText{.min_jacobian = "0.1"}}) {
    EXPECT_TRUE(app::fails_a_demand(asked, cells));
    EXPECT_FALSE(app::fails_a_demand(asked, moves));
    EXPECT_FALSE(app::fails_a_demand(asked, bounds));
  }
  for (const ConstraintText& asked :
       {ConstraintText{.max_move = "1"}, ConstraintText{.limit = {"all max-move 1"}}}) {
    EXPECT_FALSE(app::fails_a_demand(asked, cells));
    EXPECT_TRUE(app::fails_a_demand(asked, moves));
    EXPECT_FALSE(app::fails_a_demand(asked, bounds));
  }
  const ConstraintText keep{.keep = {"area"}};
  EXPECT_FALSE(app::fails_a_demand(keep, cells));
  EXPECT_FALSE(app::fails_a_demand(keep, moves));
  EXPECT_TRUE(app::fails_a_demand(keep, bounds));
}

TEST(Demands, ThatNobodyMadeOrThatAreMetDoNotCount) {
  const Holding unmet{{}, {kUnmetCell}, {kUnmet}, {kUnmet}};
  EXPECT_FALSE(app::fails_a_demand({}, unmet));
  EXPECT_FALSE(app::fails_a_demand({.symmetry = {"x=0"}, .max_deviation = "1"}, unmet));
  const Holding met{{}, {kMetCell}, {kMet}, {kMet}};
  const ConstraintText all{.max_move = "1", .min_jacobian = "0.1", .keep = {"area"}};
  EXPECT_FALSE(app::fails_a_demand(all, met));
  EXPECT_FALSE(app::fails_a_demand(all, {}));
}

// A run on a grid of 3 x 3 vertices, of which some are fixed, that came to its end in one step.
class OutcomeOfAGrid : public ::testing::Test {
 protected:
  OutcomeOfAGrid() {
    input_.file.mesh = shapes::quad_grid(2);
    input_.file.patch = std::make_unique<testing::PatchStub>();
    input_.orientation = problem_.orientation = find_orientation(mesh());
    fix({});
    problem_.bounds.push_back(make_keep(mesh(), problem_.orientation, Keep::area));
    report_.stop = Stop::converged;
    report_.history = {{.number = 0}, {.number = 1}};
  }
  const Mesh& mesh() const { return input_.file.mesh; }
  void fix(const std::vector<Index>& vertices) {
    std::vector<char> fixed(mesh().point_count(), 0);
    for (const Index v : vertices) fixed[v] = 1;
    problem_.motion = Motion(mesh(), problem_.orientation, fixed);
  }
  std::string outcome() {
    report_.unmet =
        report_.holding.cells.size() + report_.holding.moves.size() + report_.holding.bounds.size();
    return app::outcome({arguments_, input_, problem_, report_});
  }

  app::SmoothArguments arguments_;
  app::Input input_;
  Problem problem_;
  Report report_;
};

TEST_F(OutcomeOfAGrid, IsASentence) { EXPECT_EQ(outcome(), "converged in 1 iteration"); }

TEST_F(OutcomeOfAGrid, CountsTheVerticesOfACellThatCannotGo) {
  report_.holding.cells = {kUnmetCell};
  const std::string cell =
      "converged in 1 iteration; 1 demand is not met: face 0 is too small or inverted";
  EXPECT_EQ(outcome(), cell);
  fix({0, 8});
  EXPECT_EQ(outcome(), cell + " (1 of its 4 vertices is fixed or slides on a line)");
  fix({0, 1, 3});
  EXPECT_EQ(outcome(), cell + " (3 of its 4 vertices are fixed or slide on a line)");
}

TEST_F(OutcomeOfAGrid, AdvisesToLowerADemandThatWasMade) {
  report_.holding.cells = {kUnmetCell};
  arguments_.constraints.min_jacobian = "0.9999";
  const std::string cell =
      "converged in 1 iteration; 1 demand is not met: face 0 is too small or inverted; lower the "
      "demand";
  EXPECT_EQ(outcome(), cell);
  fix({0, 1});
  EXPECT_EQ(outcome(), cell + " (2 of its 4 vertices are fixed or slide on a line)");
}

TEST_F(OutcomeOfAGrid, DoesNotBlameVerticesWhereOthersWerePulledBack) {
  report_.holding.cells = {kUnmetCell};
  report_.pulled_back = 2;
  fix({0, 1});
  EXPECT_EQ(outcome(),
            "converged in 1 iteration; 2 vertices pulled back so that nothing is worse than "
            "before; 1 demand is not met: face 0 is too small or inverted");
}

TEST_F(OutcomeOfAGrid, NamesWhatWasAskedForBeforeWhatHoldsByDefault) {
  report_.holding.cells = {kUnmetCell};
  report_.holding.moves = {kUnmet};
  arguments_.constraints.max_move = "0.1";
  EXPECT_EQ(outcome(),
            "converged in 1 iteration; 2 demands are not met, the first: vertex 4 is 0.25 too far "
            "from where it was");
  arguments_.constraints.min_area = "1";
  EXPECT_NE(outcome().find("the first: face 0"), std::string::npos) << outcome();
}

TEST_F(OutcomeOfAGrid, NamesAFunctionThatIsOff) {
  report_.holding.bounds = {{0, 1.0, 0.25}};
  EXPECT_EQ(outcome(), "converged in 1 iteration; 1 demand is not met: " +
                           std::string(problem_.bounds[0].function->name()) + " is off by 0.25");
}

}  // namespace
}  // namespace evenmesh
