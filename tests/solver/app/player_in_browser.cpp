#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/solver/app/program.hpp"

// The HTML player in a real browser, run without a window.

namespace {

std::string browser() {
  for (const char* name : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"})
    if (::access(name, X_OK) == 0) return name;
  return {};
}

/// Reports the test as skipped if there is no browser.
struct BrowserNeeded {
  BrowserNeeded() {
    if (!browser().empty()) return;
    std::fprintf(stderr, "player_in_browser: skipped, chromium is not installed (scripts/setup --test installs it)\n");
    std::_Exit(77);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(player_in_browser_tests, *boost::unit_test::fixture<BrowserNeeded>())

namespace {

/// The first 50 ms of sample2 in 26 states, 2 ms apart, and the page that plays them.
const fs::path& player() {
  static const Folder folder;
  static const bool made = [] {
    const std::string run = (folder.path / "run").string();
    return talus_ran({"run", scene("fence/sample2.DAT"), "--end", "50 ms", "--frames", "25", "--out", run}).code == 0 &&
           talus_ran({"animate", run}).code == 0;
  }();
  BOOST_REQUIRE(made);
  static const fs::path page = folder.path / "run/plots/animation.html";
  return page;
}

/// The page's document after this many milliseconds of its virtual clock.
std::string document(const fs::path& page, const std::string& hash, int milliseconds = 500) {
  const Folder profile;
  const Ended ended = ran(browser(), {"--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                                      "--allow-file-access-from-files", "--user-data-dir=" + profile.path.string(),
                                      "--virtual-time-budget=" + std::to_string(milliseconds), "--dump-dom",
                                      "file://" + page.string() + "#" + hash});
  BOOST_REQUIRE(ended.code == 0);
  BOOST_TEST(holds(ended.out, "data-ready=\"yes\""));
  BOOST_TEST(!holds(ended.out, "data-error="), ended.out.substr(0, 300));
  return ended.out;
}

/// The attribute or text that follows the first occurrence of `mark`.
std::string after(const std::string& text, const std::string& mark) {
  const std::size_t begin = text.find(mark);
  BOOST_REQUIRE(begin != std::string::npos);
  return text.substr(begin + mark.size(), text.find_first_of("\"<", begin + mark.size()) - begin - mark.size());
}

std::string time_shown(const std::string& text) { return after(text, "<output id=\"time\">"); }
/// Body 1 is the rock.
std::string rock(const std::string& text) { return after(text, "id=\"body1\" transform=\""); }

}  // namespace

BOOST_AUTO_TEST_CASE(the_time_in_the_address_is_shown) {
  const std::string start = document(player(), "");
  const std::string later = document(player(), "t=.02");
  BOOST_TEST(time_shown(start) == "t = 0 s");
  BOOST_TEST(time_shown(later) == "t = 0.01986 s");  // the state nearest to 0.02 s: 240 steps of 82.7374 us
  BOOST_TEST(rock(start) != rock(later));
  // Circles and columns in both views, the top cables taut and coloured, the bottom ones slack.
  for (const char* part : {"<polygon class=\"rock\"", "<polygon class=\"column\"", "class=\"cable\"", "stroke=\"rgb(",
                           "class=\"cable slack\"", "<svg id=\"along\"", "class=\"cursor\""})
    BOOST_TEST(holds(start, part), part);
  BOOST_TEST(after(start, "class=\"cursor\" y1=\"8\" y2=\"") != "");
  BOOST_TEST(after(start, "class=\"cursor\"").empty() == after(later, "class=\"cursor\"").empty());
}

// The half model's 7 columns, and 6 bottom and 7 top segments per layer, all with mirror images except the central
// column.
BOOST_AUTO_TEST_CASE(a_half_model_is_seen_whole_along_the_fence) {
  const std::string page = document(player(), "t=.02");
  const std::size_t begin = page.find("<svg id=\"along\"");
  const std::string along = page.substr(begin, page.find("</svg>", begin) - begin);
  const auto count = [&along](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = along.find(part); at != std::string::npos; at = along.find(part, at + 1))
      ++found;
    return found;
  };
  BOOST_TEST(count("class=\"column\"") == 2U * 13U);
  BOOST_TEST(count("class=\"rock\"") == 1U);
  BOOST_TEST(count("class=\"cable\"") + count("class=\"cable slack\"") == 2U * 26U);
  BOOST_TEST(holds(page, "below z = 0 the half model's mirror image"));
}

BOOST_AUTO_TEST_CASE(playing_goes_on_to_the_end) {
  const std::string playing = document(player(), "play&speed=8&loop=0", 500);
  const std::string ended = document(player(), "play&speed=8&loop=0", 5000);
  const int first = std::stoi(after(playing, "data-frame=\""));
  BOOST_TEST(first > 2);
  BOOST_TEST(first < 25);
  BOOST_TEST(after(ended, "data-frame=\"") == "26");
  BOOST_TEST(holds(playing, ">Pause</button>"));
  BOOST_TEST(holds(ended, ">Play</button>"));
}

// 80 discs between two rows of 11, with the images in the view, coloured by the chosen quantity; bars have edges.
BOOST_AUTO_TEST_CASE(discs_are_played_with_their_images) {
  const Folder folder;
  const std::string file = folder.file(
      "CNTRL.DAT", "0 1\n1.7e4 34693.877551020405 1e-3 7.2e-7 9.81 0.00897\n8 10 11 5.0\n6e-7 2.5e-3 2.5e-2\n");
  const std::string run = (folder.path / "run").string();
  BOOST_REQUIRE(talus_ran({"cell", file, "--out", run}).code == 0);
  BOOST_REQUIRE(talus_ran({"animate", run}).code == 0);
  const auto shown = [&](const std::string& hash) { return document(folder.path / "run/plots/animation.html", hash); };
  const auto count = [](const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++found;
    return found;
  };
  const std::string speed = shown("t=.025"), force = shown("t=.025&colour=force");
  BOOST_TEST(time_shown(speed) == "t = 0.025");
  // 22 wall discs and 80 free ones; 3 of 11 in a row lie within 1.5 mm of a border and are drawn twice, free ones
  // approximately so. Discs of the base that just touch the view are drawn or not depending on the rounding of their
  // positions.
  const auto walls = count(speed, "class=\"disc wall\"");
  BOOST_TEST((walls >= 28U && walls <= 30U));
  BOOST_TEST(count(speed, "class=\"disc\"") > 80U + 8U);
  BOOST_TEST(count(speed, "class=\"disc\"") < 80U + 8U * 4U);
  BOOST_TEST(count(speed, "class=\"contact\"") > 10U);
  BOOST_TEST(count(speed, "class=\"contact\"") == count(speed, "class=\"contact edge\""));
  BOOST_TEST(count(speed, "class=\"border\"") == 2U);
  BOOST_TEST(speed != force);
  BOOST_TEST(!holds(speed, "NaN"));
}

/// Appearance of a page on a screen of a given width: width of its content, smallest letters [px], and names of
/// controls outside the screen. A browser's window cannot be that narrow, a frame can.
struct Screen {
  double width{}, letters{};
  std::string hidden;
};
Screen screen(const fs::path& page, int width, const std::string& operated = "") {
  const Folder folder;
  const fs::path frame = folder.path / "frame.html";
  std::ofstream{frame} << "<!DOCTYPE html><body><iframe id=\"screen\" style=\"width:" << width
                       << "px;height:844px;border:0\" src=\"file://" << page.string() << R"("></iframe><script>
    const screen_ = document.getElementById("screen");
    screen_.onload = () => setTimeout(() => {
      const seen = screen_.contentDocument, view = screen_.contentWindow;
      let letters = 1e9;
      const texts = seen.createTreeWalker(seen.body, NodeFilter.SHOW_TEXT);
      while (texts.nextNode()) {
        const parent = texts.currentNode.parentElement, box = parent.getBoundingClientRect();
        if (!texts.currentNode.data.trim() || box.width === 0 || parent.closest("script, select")) continue;
        const matrix = parent.ownerSVGElement ? parent.getScreenCTM() : {a: 1, b: 0};
        const scale = Math.hypot(matrix.a, matrix.b);
        letters = Math.min(letters, scale * parseFloat(view.getComputedStyle(parent).fontSize));
      }
      const hidden = ")"
                       << operated << R"(".split(" ").filter(id => {
        if (!id) return false;
        const box = seen.getElementById(id).getBoundingClientRect();
        return box.width < 10 || box.left < 0 || box.right > view.innerWidth || box.top < 0 || box.bottom > 844;
      });
      const width = Math.max(seen.documentElement.scrollWidth, seen.body.scrollWidth);
      document.body.dataset.seen = [width, letters, ...hidden].join(" ");
      document.documentElement.dataset.ready = "yes";
    }, 500);</script>)";
  std::istringstream seen{after(document(frame, "", 5000), "data-seen=\"")};
  Screen made;
  seen >> made.width >> made.letters;
  std::getline(seen, made.hidden);
  return made;
}

constexpr double eight_points = 8.0 * 96.0 / 72.0;  // [px]

// A script at the page's end presses keys, moves the slider and points into a chart, and records the state shown.
BOOST_AUTO_TEST_CASE(keys_slider_and_charts_lead_through_time) {
  std::string text = talus::read_text(player());
  const std::string script = R"(<script>{
    const noted = [];
    const note = () => noted.push(Number(document.body.dataset.frame));
    const press = (key, more) => { document.dispatchEvent(new KeyboardEvent("keydown", {key, ...more})); note(); };
    press("ArrowRight"); press("ArrowRight", {shiftKey: true}); press("ArrowLeft"); press("End"); press("Home");
    const slider = document.getElementById("scrub");
    slider.value = 7; slider.dispatchEvent(new Event("input")); note();
    const chart = document.querySelector(".chart"), box = chart.getBoundingClientRect();
    chart.dispatchEvent(new PointerEvent("pointerdown",
      {clientX: box.right - 10, clientY: box.top + 20, buttons: 1, bubbles: true})); note();
    press(" "); const plays = document.getElementById("play").textContent; press(" ");
    press("+"); const speed = document.getElementById("speed").value;
    document.getElementById("theme").click();
    document.body.dataset.noted = noted.slice(0, 7).join(" ") + " " + plays + " " + speed + " " +
      document.documentElement.dataset.theme;
    }</script>)";
  text.insert(text.rfind("</body>"), script);
  const Folder folder;
  std::ofstream{folder.path / "pressed.html"} << text;
  const std::string seen = document(folder.path / "pressed.html", "theme=light");
  BOOST_TEST(after(seen, "data-noted=\"") == "1 11 10 26 0 7 26 Pause 2 dark");
}

BOOST_AUTO_TEST_CASE(a_phone_shows_the_player_with_its_controls) {
  const Screen phone = screen(player(), 390, "play scrub speed loop theme time");
  BOOST_TEST(phone.width <= 390.0);
  BOOST_TEST(phone.letters >= eight_points);
  BOOST_TEST(phone.hidden == "");
}

BOOST_AUTO_TEST_CASE(the_sheet_is_read_on_a_phone_and_on_a_screen) {
  const Folder folder;
  const std::string run = (folder.path / "run").string();
  const Ended made = talus_ran({"run", scene("fence/table_2.toml"), "--end", "50 ms", "--sheet", "--out", run});
  BOOST_REQUIRE(made.code == 0);
  for (const int width : {390, 700, 801, 1100}) {
    const Screen seen = screen(folder.path / "run/sheet.html", width);
    BOOST_TEST_CONTEXT(width) {
      BOOST_TEST(seen.width <= width);
      BOOST_TEST(seen.letters >= eight_points);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
