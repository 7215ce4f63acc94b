// SPDX-License-Identifier: BSD-3-Clause
#include "paper/plots.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <regex>
#include <system_error>

#include "processes.h"

namespace tzc {
namespace bench {
namespace {

// Okabe and Ito's colours, which people with any kind of colour vision can tell apart, then shades of them: boxes stand
// in the order of the key.
constexpr const char* colours[] = {"#D55E00", "#009E73", "#0072B2", "#56B4E9", "#E69F00", "#CC79A7",
                                   "#777777", "#000000", "#8C3D00", "#00694D", "#7FB8D8", "#A87300",
                                   "#8F4C73", "#B8A800", "#444466", "#AAAAAA"};
constexpr double box_share = 0.8;     // of a box's place
constexpr double group_width = 0.86;  // of the distance between two sizes

/// 10 to this power of microseconds: "10 µs", "1 ms".
std::string latency_text(int power) {
  const int unit = std::clamp(power < 0 ? -1 : power / 3, -1, 2);
  constexpr const char* units[] = {"ns", "µs", "ms", "s"};
  return fmt::format("{:g} {}", std::pow(10, power - 3 * unit), units[unit + 1]);
}

constexpr char head[] =
    R"(# Box plots of tzc-bench paper: box from the first to the third quartile, line at the median, whiskers
# from the 1st to the 99th percentile. Columns: x p1 q1 median q3 p99
set encoding utf8
set logscale y
set ylabel "one-way latency"
set xlabel "message size"
set grid ytics mytics linetype 1 linewidth 0.8 linecolor rgb "#aaaaaa", linetype 1 linewidth 0.4 linecolor rgb "#dddddd"
set border 3
set xtics nomirror scale 0
set ytics nomirror
set key outside right center Left reverse samplen 1.5 spacing 1.4
set style fill solid 0.45 border
)";

template <class Value, class Member>
std::vector<Value> in_order(const std::vector<const Summary*>& summaries, Member Cell::* member) {
  std::vector<Value> values;
  for (const Summary* summary : summaries) {
    const Value& value = summary->cell.*member;
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

std::vector<const Summary*> with_subscribers(const std::vector<Summary>& summaries, std::size_t subscribers) {
  std::vector<const Summary*> found;
  for (const Summary& summary : summaries)
    if (summary.cell.subscribers == subscribers && summary.latency_us) found.push_back(&summary);
  return found;
}

/// Where the boxes stand: a group for each size, a place in it for each contender.
struct Places {
  std::vector<std::size_t> sizes;
  std::vector<std::string> contenders;

  double width() const { return group_width / static_cast<double>(contenders.size()); }
  double of(const Cell& cell) const {
    const auto size = std::find(sizes.begin(), sizes.end(), cell.size_bytes) - sizes.begin();
    const auto one = std::find(contenders.begin(), contenders.end(), cell.contender) - contenders.begin();
    const double middle = (static_cast<double>(contenders.size()) - 1) / 2;
    return static_cast<double>(size) + (static_cast<double>(one) - middle) * width();
  }
};

Places places_of(const std::vector<const Summary*>& summaries) {
  Places places{in_order<std::size_t>(summaries, &Cell::size_bytes),
                in_order<std::string>(summaries, &Cell::contender)};
  std::sort(places.sizes.begin(), places.sizes.end());
  return places;
}

// Whole decades, with some room for the marks above the highest whisker. A tic at the very end would be left out.
std::string latency_axis(const std::vector<const Summary*>& summaries) {
  double least = 1e300, most = 0;
  for (const Summary* summary : summaries) {
    least = std::min(least, summary->latency_us->p1);
    most = std::max(most, summary->latency_us->p99);
  }
  const int bottom = static_cast<int>(std::floor(std::log10(least)));
  const int top = std::max(bottom + 1, static_cast<int>(std::ceil(std::log10(most * 1.2))));
  std::string tics;
  for (int decade = bottom; decade <= top; ++decade) {
    tics += fmt::format("{}\"{}\" 1e{}", decade > bottom ? ", " : "", latency_text(decade), decade);
    for (int step = 2; step < 10 && decade < top; ++step) tics += fmt::format(", \"\" {}e{} 1", step, decade);
  }
  return fmt::format("set yrange [0.999e{}:1e{}]\nset ytics ({})\n", bottom, top, tics);
}

std::string title(const std::vector<const Summary*>& summaries, std::size_t subscribers) {
  const bool marked = std::any_of(summaries.begin(), summaries.end(),
                                  [](const Summary* summary) { return !in_full(*summary); });
  const bool load = summaries.front()->cell.conditions.load;
  return fmt::format("set title \"{} subscriber{}{}{}\"\n", subscribers, subscribers == 1 ? "" : "s",
                     load ? ", every processor busy with other work" : "",
                     marked ? "   (* messages were lost, or the publisher did not hold the rate)" : "");
}

std::string axes(const Places& places) {
  std::string text = fmt::format("set boxwidth {:.4f}\nset xrange [-0.55:{}]\n", places.width() * box_share,
                                 static_cast<double>(places.sizes.size()) - 0.45);
  text += "set xtics (";
  for (std::size_t i = 0; i < places.sizes.size(); ++i)
    text += fmt::format("{}\"{}\" {}", i > 0 ? ", " : "", size_text(places.sizes[i]), i);
  text += ")\n";
  for (std::size_t i = 1; i < places.sizes.size(); ++i)
    text += fmt::format(
        "set arrow from {0}, graph 0 to {0}, graph 1 nohead back linewidth 0.6 linecolor rgb \"#bbbbbb\"\n",
        static_cast<double>(i) - 0.5);
  return text;
}

// "*" above what was not delivered in full or in time.
std::string marks(const std::vector<const Summary*>& summaries, const Places& places) {
  std::string text;
  for (const Summary* summary : summaries)
    if (!in_full(*summary))
      text += fmt::format("set label \"*\" at {:.4f}, {:.3f} center offset 0, 0.5 front\n",
                          places.of(summary->cell), summary->latency_us->p99);
  return text;
}

std::string data(const std::vector<const Summary*>& summaries, const Places& places) {
  std::string text;
  for (std::size_t i = 0; i < places.contenders.size(); ++i) {
    text += fmt::format("$boxes{} << END\n", i);
    for (const Summary* summary : summaries) {
      if (summary->cell.contender != places.contenders[i]) continue;
      const Spread& us = *summary->latency_us;
      text += fmt::format("{:.4f} {:.3f} {:.3f} {:.3f} {:.3f} {:.3f}\n", places.of(summary->cell), us.p1,
                          us.q1, us.median, us.q3, us.p99);
    }
    text += "END\n";
  }
  return text;
}

std::string plot(const Places& places) {
  const double box = places.width() * box_share;
  std::string text = "plot";
  for (std::size_t i = 0; i < places.contenders.size(); ++i)
    text += fmt::format(
        "{0} \\\n  $boxes{1} using 1:3:2:6:5 with candlesticks whiskerbars 0.6 linewidth 1 linecolor rgb "
        "\"{2}\" "
        "title \"{3}\", \\\n  $boxes{1} using ($1-{4:.4f}):4:({5:.4f}):(0) with vectors nohead linewidth 2.5 "
        "linecolor rgb \"{2}\" notitle",
        i > 0 ? "," : "", i, colour_at(i), places.contenders[i], box / 2, box);
  return text + "\n";
}

// What gnuplot says goes to the file log. -d: the user's own settings, of ~/.gnuplot, would change the plot.
[[noreturn]] void become_gnuplot(const std::string& folder, const std::string& script,
                                 const std::string& log) {
  const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(out, STDERR_FILENO);
  if (::chdir(folder.c_str()) == 0)
    ::execlp("gnuplot", "gnuplot", "-d", script.c_str(), static_cast<char*>(nullptr));
  ::_exit(127);
}

void run_gnuplot(const Store& store, const std::string& script) {
  const std::string log = "gnuplot.log";
  const pid_t gnuplot = in_child([&] {
    become_gnuplot(store.path_of(""), script, std::filesystem::absolute(store.path_of(log + ".tmp")));
  });
  const Ending ending = wait_for(gnuplot);
  if (ending == Ending::interrupted) stop({gnuplot});
  const std::string said = ending == Ending::failed ? store.read(log + ".tmp") : "interrupted";
  store.discard(log);
  if (ending != Ending::exited) throw StoreError("gnuplot failed on " + store.path_of(script) + ": " + said);
}

/// Of a plot: the ending of its file's name, and how the file ends.
struct Format {
  const char* ending;
  const char* last;
};
constexpr Format formats[] = {{".svg", "</svg>"}, {".png", "IEND\xae\x42\x60\x82"}};

bool is_whole(const std::string& file, const std::string& last) {
  const std::size_t end = file.find_last_not_of("\r\n ") + 1;  // npos + 1 is 0
  return end >= last.size() && file.compare(end - last.size(), last.size(), last) == 0;
}

/// gnuplot ends with status 0 also where its output could not be written.
void require_whole(const Store& store, const std::string& name) {
  for (const Format& format : formats)
    if (!is_whole(store.read(name + format.ending + ".tmp"), format.last))
      throw StoreError("gnuplot has not written all of " + store.path_of(name + format.ending) +
                       ": is the disk full?");
}

}  // namespace

const char* colour_at(std::size_t contender) {
  return colours[contender % std::size(colours)];
}

std::string outputs(const std::string& name, const std::string& plot) {
  std::string id = name;  // of the elements, where several plots stand in one page
  std::replace(id.begin(), id.end(), '-', '_');
  return fmt::format(
      "set terminal svg size 1100, 560 dynamic font \"sans-serif,13\" name \"{2}\" noenhanced background "
      "\"white\"\n"
      "set output \"{0}.svg.tmp\"\n{1}"
      "set terminal pngcairo size 1650, 840 font \"sans-serif,13\" fontscale 1.4 linewidth 1.5 noenhanced\n"
      "set output \"{0}.png.tmp\"\n{1}",
      name, plot, id);
}

std::string gnuplot_version() {
  std::FILE* pipe = ::popen("gnuplot --version 2>/dev/null", "r");
  if (pipe == nullptr) return "";
  char line[100] = {};
  const std::string text = std::fgets(line, sizeof line, pipe) != nullptr ? line : "";
  const bool works = ::pclose(pipe) == 0;
  const std::size_t name_end = text.find(' ');
  if (!works || name_end == std::string::npos) return "";
  return text.substr(name_end + 1, text.find('\n') - name_end - 1);
}

std::string plot_name(std::size_t subscribers, const Conditions& conditions) {
  return fmt::format("latency-{}{}", subscribers, suffix_of(conditions));
}

std::string plot_script(const std::vector<Summary>& summaries, std::size_t subscribers) {
  const std::vector<const Summary*> shown = with_subscribers(summaries, subscribers);
  if (shown.empty()) return "";
  const Places places = places_of(shown);
  return head + latency_axis(shown) + title(shown, subscribers) + axes(places) + marks(shown, places) +
         data(shown, places) + outputs(plot_name(subscribers, shown.front()->cell.conditions), plot(places));
}

std::string draw(const Store& store, const std::string& name, const std::string& script) {
  if (script.empty()) return "";
  store.write(name + ".gnuplot", script);
  try {
    run_gnuplot(store, name + ".gnuplot");
    require_whole(store, name);
  } catch (const StoreError&) {
    for (const Format& format : formats) store.discard(name + format.ending);
    throw;
  }
  for (const Format& format : formats) store.take(name + format.ending);
  return store.read(name + ".svg");
}

void remove_plots_but(const std::set<std::string>& drawn, const Store& store) {
  const std::regex plot("(latency-[0-9]+(-rt)?(-load)?|real-time)\\.(svg|png|gnuplot)");
  std::vector<std::string> gone;
  std::error_code failed;
  for (std::filesystem::directory_iterator entry(store.path_of(""), failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const std::string file = entry->path().filename().string();
    if (std::regex_match(file, plot) && drawn.count(entry->path().stem().string()) == 0) gone.push_back(file);
  }
  for (const std::string& file : gone) store.remove(file);
}

}  // namespace bench
}  // namespace tzc
