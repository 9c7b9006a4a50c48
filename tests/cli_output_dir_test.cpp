// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "cli/output_dir.hpp"
#include "cli/terminal.hpp"
#include "selion/core/error.hpp"
#include "selion/output/file_name.hpp"

using namespace selion;
using namespace selion::cli;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// An empty folder that is gone after the test.
struct Scratch {
  fs::path at = fs::temp_directory_path() / ("selion-test-" + std::to_string(std::random_device{}()));
  Scratch() { fs::create_directories(at); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { fs::remove_all(at); }
};

std::string text_at(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::recursive_directory_iterator{folder}, {}));
}

constexpr auto kNames = std::to_array<std::string_view>({"a.txt", "b.txt"});
const std::array<OutputFile, 2> kFiles{{{"a.txt", "one"}, {"b.txt", "two"}}};

}  // namespace

TEST_CASE("a folder's name is safe whatever the field is called", "[cli]") {
  CHECK(folder_name(7, "Long acre") == "7_Long_acre");
  CHECK(folder_name(1, "../../etc/passwd") == "1_.._.._etc_passwd");
  CHECK(folder_name(2, "..") == "2");
  CHECK(folder_name(3, "") == "3");
  CHECK(folder_name(4,
                    "Ca\xC3\xB1"
                    "ada / B") ==
        "4_Ca\xC3\xB1"
        "ada_B");
  CHECK(folder_name(5, "bad \xFF\xC3 bytes") == "5_bad_bytes");
  CHECK(folder_name(6, std::string("a\0b\nc", 5)) == "6_a_b_c");
  CHECK(folder_name(8, "CON") == "8_CON");
  CHECK(folder_name(9, "dots...") == "9_dots");
}

TEST_CASE("a long name is cut between characters", "[cli]") {
  std::string umlauts;
  for (int i = 0; i < 300; ++i) umlauts += "\xC3\xBC";
  const std::string name = folder_name(12, umlauts);
  CHECK(name.size() <= 100);
  CHECK((name.size() - 3) % 2 == 0);
}

TEST_CASE("files are written whole, and nothing else is left", "[cli]") {
  const Scratch scratch;
  const fs::path folder = scratch.at / "new" / "deep";
  write_output(folder, kFiles, Existing::refuse);
  CHECK(text_at(folder / "a.txt") == "one");
  CHECK(text_at(folder / "b.txt") == "two");
  CHECK(entries(folder) == 2);
}

TEST_CASE("an existing file is replaced only when that was said, and only ours", "[cli]") {
  const Scratch scratch;
  std::ofstream{scratch.at / "b.txt"} << "old";
  std::ofstream{scratch.at / "mine.txt"} << "mine";
  CHECK_THROWS_WITH(check_output(scratch.at, kNames, Existing::refuse),
                    Contains("b.txt: exists; give --overwrite"));
  CHECK_THROWS_AS(write_output(scratch.at, kFiles, Existing::refuse), InputError);
  CHECK(text_at(scratch.at / "b.txt") == "old");
  CHECK(entries(scratch.at) == 2);

  CHECK_NOTHROW(check_output(scratch.at, kNames, Existing::replace));
  write_output(scratch.at, kFiles, Existing::replace);
  CHECK(text_at(scratch.at / "b.txt") == "two");
  CHECK(text_at(scratch.at / "mine.txt") == "mine");
  CHECK(entries(scratch.at) == 3);
}

TEST_CASE("what cannot be a folder is refused before anything is planned", "[cli]") {
  const Scratch scratch;
  std::ofstream{scratch.at / "file"} << "x";
  fs::create_directory(scratch.at / "a.txt");
  CHECK_THROWS_WITH(check_output(scratch.at / "file", kNames, Existing::replace),
                    Contains("is not a folder"));
  CHECK_THROWS_WITH(check_output(scratch.at / "file" / "below", kNames, Existing::replace),
                    Contains("is not a folder"));
  CHECK_THROWS_WITH(check_output(scratch.at, kNames, Existing::replace), Contains("a.txt: is a folder"));
  CHECK_NOTHROW(check_output(scratch.at / "not" / "yet", kNames, Existing::refuse));
}

TEST_CASE("a write that fails takes back what it began", "[cli]") {
  const Scratch scratch;
  const std::string too_long(300, 'x');  // no file system takes this name
  const std::array<OutputFile, 2> files{{{"a.txt", "one"}, {too_long, "two"}}};
  CHECK_THROWS_WITH(write_output(scratch.at / "p" / "q", files, Existing::refuse),
                    Contains(too_long + ": cannot be written: "));
  CHECK(entries(scratch.at) == 0);
}

TEST_CASE("names from files cannot rule the terminal", "[cli]") {
  CHECK(printable("a\x1b[31mb\n") == "a [31mb ");
  CHECK(printable("\xC2\x9Bx") == " x");
  CHECK(printable("F\xC3\xBCld \xE2\x80\x94") == "F\xC3\xBCld \xE2\x80\x94");
  CHECK(printable("a\xE2\x80\xAE"
                  "b\xE2\x81\xA6"
                  "c\xE2\x80") == "a b c\xE2\x80");
}
