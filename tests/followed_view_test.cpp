// Cameras that follow the contents of a system, whenever they are set.

#include "displayfile/mesh/followed_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/user_routines/system_inside.h"

namespace displayfile {
namespace {

void enter_box(GraphicsSystem& system, int segment, const Point3& low, double size = 1.0) {
  system.open_segment(segment);
  box_3(system, low, low + Point3(size));
  system.close_segment();
}

/// The dump of the same boxes entered in a view that was fitted to all of them before.
std::string entered_in(const View& view, const std::vector<Point3>& boxes) {
  GraphicsSystem system;
  system.set_light({0.0, 0.0, 1.0});
  set_fitted_view(view, system, {system.view(), system.explicit_settings()});
  int segment = 1;
  for (const Point3& box : boxes) enter_box(system, segment++, box);
  return dump(system.display_file());
}

class FollowedViews : public testing::Test {
 protected:
  FollowedViews() { system_.set_light({0.0, 0.0, 1.0}); }
  std::string dumped() {
    followed_.bring_up_to_date(system_);
    return dump(system_.display_file());
  }
  GraphicsSystem system_;
  FollowedView followed_;
};

TEST_F(FollowedViews, SegmentsAreViewedAsIfEnteredInTheFittedView) {
  const std::vector<Point3> boxes{{0, 0, 0}, {50, 2, 1}, {-3, 700, 9}};
  followed_.look(system_, {.eye = EyeDirection{70.0, 25.0}, .upright = upright("z")});
  for (int k = 0; k < 3; ++k) {
    followed_.place(system_);
    enter_box(system_, k + 1, boxes[static_cast<std::size_t>(k)]);
    const std::string drawn = dumped();  // between: with the contents so far
    EXPECT_EQ(drawn, entered_in(*followed_.view(), {boxes.begin(), boxes.begin() + k + 1}));
  }
  const std::string before = dumped();
  followed_.look(system_, {.eye = EyeDirection{10.0, 5.0}, .angle_of_view = 30.0});
  const std::string after = dumped();
  EXPECT_NE(after, before);
  EXPECT_EQ(after, entered_in(*followed_.view(), boxes));
}

TEST_F(FollowedViews, ScenesThatWereRetainedAreFollowedToo) {
  system_.retain();
  enter_box(system_, 1, {100, 100, 100});
  followed_.look(system_, {});
  const std::string drawn = dumped();
  EXPECT_EQ(drawn, entered_in(*followed_.view(), {{100, 100, 100}}));
}

TEST_F(FollowedViews, WhatIsSortedIsSortedAgain) {
  system_.set_hidden_surfaces({.removal = true, .method = HiddenMethod::bsp});
  followed_.look(system_, {});
  enter_box(system_, 1, {0, 0, 0});
  followed_.bring_up_to_date(system_);
  EXPECT_NE(system_.display_file().segment(1).sorted(), nullptr);
}

TEST_F(FollowedViews, ViewParametersEndItAndAreKept) {
  followed_.look(system_, {});
  enter_box(system_, 1, {0, 0, 0});
  const std::string fitted = dumped();
  followed_.running(system_, true, [&] { system_.set_perspective({3, 2, 60}); });
  EXPECT_FALSE(followed_.follows());
  EXPECT_EQ(dump(system_.display_file()), fitted);
  enter_box(system_, 2, {0, 0, 0});
  EXPECT_GT(system_.display_file().segment(2).polygons(), 0u);
  EXPECT_THROW(followed_.look(system_, {}), Error);
}

TEST_F(FollowedViews, AfterAViewportAnotherCameraFollowsTheNextSegmentsAlone) {
  followed_.look(system_, {});
  enter_box(system_, 1, {0, 0, 0});
  followed_.running(system_, true, [&] { system_.set_viewport(0.5, 1.0, 0.0, 1.0); });
  const View first = system_.retained()->segments().front().view;
  followed_.look(system_, {.eye = EyeDirection{80.0, 0.0}});
  enter_box(system_, 2, {900, 0, 0});
  followed_.bring_up_to_date(system_);
  EXPECT_EQ(system_.retained()->segments().front().view, first);
  EXPECT_EQ(system_.retained()->segments().back().view.viewport.x_min, 0.5);
}

TEST_F(FollowedViews, SegmentsKeepTheirNumbersWhenOthersAreDeleted) {
  followed_.look(system_, {});
  enter_box(system_, 1, {0, 0, 0});
  followed_.enter_beside(system_, 0.1, [&] { enter_box(system_, 2, {0, 0, 0}, 0.1); });
  const View beside = system_.retained()->segments().back().view;
  followed_.place(system_);
  enter_box(system_, 3, {5, 5, 5});
  system_.delete_segment(1);
  followed_.bring_up_to_date(system_);
  EXPECT_EQ(system_.retained()->segments()[0].view.window, beside.window);
  EXPECT_EQ(system_.retained()->segments()[0].view.viewport, beside.viewport);
  EXPECT_TRUE(followed_.is_beside(system_.retained()->segments()[0]));
  EXPECT_FALSE(followed_.is_beside(system_.retained()->segments()[1]));
  EXPECT_EQ(system_.retained()->segments()[1].view, *followed_.view());
}

TEST_F(FollowedViews, TextsHaveRoomForTheirLetters) {
  constexpr double kAdvance = 0.6, kSize = 0.05;
  const std::string letters(6, 'x');
  const double reach = kAdvance * kSize * static_cast<double>(letters.size());
  struct Outward {
    Point3 anchor;
    TextStyle::Alignment alignment;
  };
  const Outward sides[] = {{{1.0, 1.0, 0.0}, TextStyle::Alignment::left},
                           {{0.0, 0.0, 1.0}, TextStyle::Alignment::right}};
  for (const std::optional<double> angle : {std::optional<double>(), std::optional(30.0)}) {
    for (const double aspect : {1.0, 1.7}) {
      for (const auto& [anchor, alignment] : sides) {
        GraphicsSystem system;
        FollowedView followed;
        followed.look(system, {.eye = EyeDirection{70.0, 25.0}, .angle_of_view = angle});
        system.open_segment(1);
        box_3(system, {0, 0, 0}, {1, 1, 1});
        system.set_text_style({.size = kSize, .alignment = alignment});
        system.move_abs_3(anchor.x, anchor.y, anchor.z);
        system.text(letters);
        system.close_segment();
        followed.bring_up_to_date(system, aspect);
        const double at = system.to_device(anchor)->x * aspect;
        EXPECT_GE(alignment == TextStyle::Alignment::left ? at : at - reach, 0.0);
        EXPECT_LE(alignment == TextStyle::Alignment::left ? at + reach : at, aspect);
      }
    }
  }
}

TEST_F(FollowedViews, TextsForWhichThereIsNoRoomLeaveTheSceneAsItIs) {
  for (const std::optional<double> angle : {std::optional<double>(), std::optional(30.0)}) {
    std::vector<View> views;
    for (const std::string& text : {std::string("x"), std::string(200, 'x')}) {
      GraphicsSystem system;
      FollowedView followed;
      followed.look(system, {.eye = EyeDirection{70.0, 25.0}, .angle_of_view = angle});
      system.open_segment(1);
      box_3(system, {0, 0, 0}, {1, 1, 1});
      system.set_text_style({.alignment = TextStyle::Alignment::centre});
      system.move_abs_3(0.5, 0.5, 0.5);
      system.text(text);
      system.close_segment();
      followed.bring_up_to_date(system);
      views.push_back(*followed.view());
    }
    EXPECT_EQ(views[0], views[1]);
  }
}

TEST_F(FollowedViews, ColumnsAreWideEnoughInNarrowPictures) {
  followed_.look(system_, {});
  enter_box(system_, 1, {0, 0, 0});
  for (int k = 2; k <= 3; ++k) {
    followed_.enter_beside(system_, 0.2, [&] { enter_box(system_, k, {0, 0, 0}, 0.1); });
  }
  for (const double aspect : {2.0, 1.0, 0.8, 0.3}) {
    followed_.bring_up_to_date(system_, aspect);
    const auto& segments = system_.retained()->segments();
    const Rectangle scene = segments[0].view.viewport;
    const Rectangle first = segments[1].view.viewport, second = segments[2].view.viewport;
    EXPECT_EQ(first.x_max, 1.0);
    EXPECT_EQ(second.x_max, first.x_min);
    EXPECT_EQ(scene.x_max, second.x_min);
    EXPECT_GE(scene.x_max, 0.3 - 1e-9);
    if (aspect < 0.5) continue;  // there the scene has what it needs
    EXPECT_NEAR((first.x_max - first.x_min) * std::min(aspect, 1.0), 0.2, 1e-9);
    EXPECT_NEAR((second.x_max - second.x_min) * std::min(aspect, 1.0), 0.2, 1e-9);
  }
}

TEST_F(FollowedViews, RecordedProgramsMakeTheSame) {
  std::ostringstream program;
  Recorder recorder(program);
  system_.set_recorder(&recorder);
  followed_.look(system_, {});
  enter_box(system_, 1, {0, 0, 0});
  followed_.enter_beside(system_, 0.1, [&] { enter_box(system_, 2, {0, 0, 0}, 0.1); });
  followed_.place(system_);
  enter_box(system_, 3, {5, 5, 5});
  const std::string expected = dumped();
  GraphicsSystem again;
  again.set_light({0.0, 0.0, 1.0});
  replay(followed_.recorded(program.str()), "recorded", again);
  EXPECT_EQ(dump(again.display_file()), expected);
}

TEST_F(FollowedViews, NothingChangesWhereACameraIsRefused) {
  followed_.look(system_, {});
  enter_box(system_, 1, {0, 0, 0});
  const std::string before = dumped();
  EXPECT_THROW(followed_.look(system_, {.eye = Point3(0.5, 0.5, 0.5)}), Error);
  EXPECT_EQ(dumped(), before);
  system_.open_segment(2);
  EXPECT_THROW(followed_.look(system_, {}), Error);
}

}  // namespace
}  // namespace displayfile
