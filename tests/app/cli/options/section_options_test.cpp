#include "app/cli/options/view_options.hpp"
#include "pipeline/input_error.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

// The meaning of --section-shows, --section-map and --section-range, and what is refused.

namespace zeroset::test::section_options_test {
namespace {

struct Looks {
    Region region;
    SectionChoice values;
    std::optional<InputError> error;
};

Looks looks_of(const ViewText& view, int sections = 2) {
    Looks looks;
    for (int i = 0; i < sections; ++i)
        looks.region.sections.push_back(make_section({1, 0, 0}, 0.1 * i));
    looks.error = read_section_looks(view, looks.region, looks.values);
    return looks;
}

Looks shown(const std::string& text, int sections = 2) {
    ViewText view;
    view.section_shows = text;
    return looks_of(view, sections);
}

TEST(SectionOptions, SayWhatAllSectionsShow) {
    struct Case {
        const char* text;
        bool cap, values;
    };
    for (const Case& c : {Case{"cap", true, false}, Case{"values", false, true},
                          Case{"values-in-cap", true, true}, Case{"nothing", false, false}}) {
        const Looks looks = shown(c.text);
        ASSERT_FALSE(looks.error) << c.text;
        for (const Section& section : looks.region.sections) {
            EXPECT_EQ(section.cap, c.cap) << c.text;
            EXPECT_EQ(section.values, c.values) << c.text;
        }
    }
}

TEST(SectionOptions, ChooseColorsAndRange) {
    ViewText view;
    view.section_map = "ember";
    view.section_range = "-200,600";
    const Looks looks = looks_of(view);
    ASSERT_FALSE(looks.error);
    EXPECT_EQ(looks.values.map, ColorMap::Ember);
    EXPECT_EQ(looks.values.range, (ValueRange{-200, 600}));
    view.section_range = "auto";
    view.section_map = "gray";
    EXPECT_EQ(looks_of(view).values, SectionChoice());
}

TEST(SectionOptions, RefuseWhatTheyDoNotKnow) {
    EXPECT_EQ(shown("colors").error->reason,
              "--section-shows colors: type cap, values, values-in-cap or nothing");
    EXPECT_EQ(shown("values", 0).error->reason,
              "--section-shows values: there is no section; add one, such as --section x=0");
    ViewText view;
    view.section_map = "rainbow";
    EXPECT_EQ(looks_of(view).error->reason,
              "--section-map rainbow: there is no such map; type one of: aurora ember balance gray "
              "cycle");
    for (const char* const range : {"1", "2,1", "1,1", "a,b", "nan,1"}) {
        view = {};
        view.section_range = range;
        const auto error = looks_of(view).error;
        ASSERT_TRUE(error) << range;
        EXPECT_TRUE(error->reason.starts_with("--section-range")) << error->reason;
    }
}

}  // namespace
}  // namespace zeroset::test::section_options_test
