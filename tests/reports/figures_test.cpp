// Figures: what is drawn is what was given, whatever was given.
#include "reports/figures/scale.hpp"
#include "reports/figures/sign_map.hpp"
#include "reports/figures/svg.hpp"
#include "reports/figures/vega_lite.hpp"
#include "reports/html.hpp"
#include "reports/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tribunal::reports {
namespace {

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(Text, numbers_are_short_and_locale_free) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(599829), "599829");
  EXPECT_EQ(number_text(5768.7123), "5768.71");
  EXPECT_EQ(number_text(1.25e-9), "1.25e-09");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(number_text(std::nan("")), "nan");
  EXPECT_EQ(fixed_text(2.0 / 3, 3), "0.667");
  EXPECT_EQ(percent_text(0.00212), "0.212 %");
  EXPECT_EQ(fixed_text(1e300, 2).size(), 304U);
}

TEST(Html, escapes_everything_that_could_end_a_context) {
  EXPECT_EQ(escape("<a href=\"x\" b='&'>"), "&lt;a href=&quot;x&quot; b=&#39;&amp;&#39;&gt;");
  EXPECT_EQ(escape("tau \xE2\x89\xA4 6N"), "tau \xE2\x89\xA4 6N");
  EXPECT_EQ(escape("\xFF|\xC0\xAF|\xED\xA0\x80|\xE2\x89"),
            "\xEF\xBF\xBD|\xEF\xBF\xBD\xEF\xBF\xBD|"
            "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD|\xEF\xBF\xBD\xEF\xBF\xBD");
  EXPECT_EQ(escape(std::string_view("a\0b", 3)),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(script_json({{"x", "</script><!--"}}), "{\"x\":\"\\u003c/script>\\u003c!--\"}");
  EXPECT_EQ(script_json({{"x", "\xFF"}}), "{\"x\":\"\\ufffd\"}");
  EXPECT_EQ(html_id("T4 \"x\""), "T4--x-");
}

TEST(Scale, ticks_are_round_and_within) {
  const Scale linear(0.13, 9.4, false, 0, 100);
  EXPECT_EQ(linear.ticks().front(), 0);
  EXPECT_EQ(linear.ticks().back(), 10);
  const Scale log(100, 100000, true, 0, 300);
  EXPECT_EQ(log.ticks().size(), 4U);
  EXPECT_NEAR(log.at(1000), 100, 1e-9);
  const Scale point(5, 5, false, 0, 1);
  EXPECT_GT(point.ticks().size(), 1U);
}

Figure sample_figure() {
  Figure figure{"Title <&>", {"N", true}, {"count"}, {}};
  figure.series.push_back({"measured", Mark::points, {{10, 1, 0.5, 1.5}, datum(100, 2)}});
  figure.series.push_back({"law", Mark::dashed, {datum(10, 1), datum(100, 2.1)}});
  return figure;
}

TEST(Svg, draws_every_point_and_escapes_the_title) {
  const std::string text = svg(sample_figure());
  EXPECT_EQ(occurrences(text, "class=\"marker\""), 2U);
  EXPECT_EQ(occurrences(text, "class=\"whisker\""), 1U);
  EXPECT_EQ(occurrences(text, "class=\"curve"), 1U);
  EXPECT_NE(text.find("Title &lt;&amp;&gt;"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(Svg, leaves_out_what_an_axis_cannot_show) {
  Figure figure = sample_figure();
  figure.series[0].data = {datum(0, 1), datum(10, std::nan("")), datum(10, HUGE_VAL), datum(-5, 2)};
  figure.series[1].data.clear();
  const std::string text = svg(figure);
  EXPECT_EQ(occurrences(text, "class=\"marker\""), 0U);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  EXPECT_FALSE(svg({}).empty());
}

TEST(VegaLite, holds_its_data_and_names_no_address) {
  const nlohmann::json spec = vega_lite(sample_figure());
  EXPECT_EQ(spec["data"]["values"].size(), 4U);
  EXPECT_EQ(spec["layer"].size(), 3U);  // lines, whiskers, points
  EXPECT_EQ(spec.dump().find("http"), std::string::npos);
  EXPECT_FALSE(spec.contains("$schema"));
  Figure points_only = sample_figure();
  points_only.series.resize(1);
  points_only.series[0].data = {datum(1, 1)};
  EXPECT_EQ(vega_lite(points_only)["layer"].size(), 1U);
}

TEST(VegaLite, has_the_same_shape_under_every_compiler) {
  const nlohmann::json spec = vega_lite(sample_figure());
  EXPECT_TRUE(spec["layer"].is_array());
  EXPECT_TRUE(spec["layer"][0]["transform"].is_array());
  EXPECT_TRUE(spec["layer"][0]["transform"][0].is_object());
  EXPECT_EQ(spec["layer"][0]["transform"][0]["filter"], "datum.kind === 'line'");
  EXPECT_TRUE(spec["layer"][0]["encoding"]["strokeDash"]["scale"]["range"][0].is_array());
  EXPECT_EQ(spec["layer"][0]["encoding"]["strokeDash"]["scale"]["range"][0], nlohmann::json::array({1, 0}));
  EXPECT_TRUE(spec["params"].is_array());
  EXPECT_EQ(spec["params"][0]["name"], "picked");
  EXPECT_EQ(spec["layer"][0]["encoding"]["x"]["scale"]["type"], "log");
}

TEST(SignMap, compares_sign_by_sign) {
  const auto map = sign_map("+[3]0[3]-[3]", "+[2]-[1]-[1]0[2]+[1]-[2]");
  ASSERT_TRUE(map.has_value());
  EXPECT_EQ(map->side, 3U);
  const std::vector<Pixel> expected{Pixel::positive,   Pixel::positive, Pixel::inverted,
                                    Pixel::false_zero, Pixel::zero,     Pixel::zero,
                                    Pixel::inverted,   Pixel::negative, Pixel::negative};
  EXPECT_EQ(map->pixels, expected);
  EXPECT_EQ(sign_map("+[1]", "0[1]")->pixels[0], Pixel::false_nonzero);
}

TEST(SignMap, malformed_texts_make_no_map) {
  for (const char* text : {"", "+", "+[", "+[]", "+[4", "+[0]", "+[-4]", "x[4]", "+[4]junk", "+[3]",
                           "+[99999999999999]", "+[4194304]+[1]", "+[18446744073709551615]"})
    EXPECT_FALSE(sign_map(text, "+[4]").has_value()) << text;
}

TEST(Png, has_the_signature_and_is_deterministic) {
  const auto map = sign_map("+[8]-[8]", "+[8]-[8]");
  const std::string bytes = png(*map);
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_EQ(bytes, png(*map));
  EXPECT_NE(bytes, png(*sign_map("+[8]-[8]", "+[7]-[9]")));
}

TEST(Base64, vectors_of_rfc_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE"), "//4=");
}

}  // namespace
}  // namespace tribunal::reports
