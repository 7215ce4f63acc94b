// SPDX-License-Identifier: BSD-3-Clause
#include "paper/store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace tzc {
namespace bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char unfinished[] = ".tmp";

std::string name_of(const Cell& cell) {
  return fmt::format("cells/{}-{}-{}{}.json", cell.contender, cell.size_bytes, cell.subscribers,
                     suffix_of(cell.conditions));
}

void remove_unfinished(const std::string& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == unfinished) fs::remove(entry.path());
}

/// An error where that cannot be found out, as in a folder that may not be entered.
bool is_there(const std::string& path) {
  std::error_code failed;
  const bool found = fs::exists(path, failed);
  if (failed) throw StoreError(fmt::format("cannot use {}: {}", path, failed.message()));
  return found;
}

int lock(const std::string& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) throw fs::filesystem_error("cannot be opened", std::error_code(errno, std::generic_category()));
  if (::flock(fd, LOCK_EX | LOCK_NB) == 0) return fd;
  ::close(fd);
  throw StoreError(
      fmt::format("another run uses {}: wait for it, or give another folder with --output", folder));
}

json to_json(const Cost& cost) {
  return {{"sent_bytes", cost.sent_bytes},
          {"received_bytes", cost.received_bytes},
          {"copied_bytes", cost.copied_bytes},
          {"page_faults", cost.page_faults},
          {"allocations", cost.allocations}};
}

Cost cost_of_json(const json& json) {
  return {json.at("sent_bytes"), json.at("received_bytes"), json.at("copied_bytes"), json.at("page_faults"),
          json.at("allocations")};
}

json to_json(const std::vector<std::uint64_t>& latencies) {
  json all = json::array();
  for (const std::uint64_t ns : latencies) all.push_back(ns != 0 ? json(ns) : json());
  return all;
}

std::vector<std::uint64_t> latencies_of_json(const json& json) {
  std::vector<std::uint64_t> latencies;
  for (const auto& ns : json) latencies.push_back(ns.is_null() ? 0 : ns.get<std::uint64_t>());
  return latencies;
}

constexpr char no_result[] = " is not a result of tzc-bench paper: remove it to have it measured again";

json parsed(const std::string& path, const std::string& text) {
  try {
    return json::parse(text);
  } catch (const json::exception&) {
    throw StoreError(path + " is no JSON: remove it to have it measured again");
  }
}

Cell cell_of(const std::string& path, const std::string& text) {
  const json document = parsed(path, text);
  try {
    return {document.at("contender"),
            document.at("size_bytes"),
            document.at("subscribers"),
            {document.at("under_load"), document.at("real_time")}};
  } catch (const json::exception&) {
    throw StoreError(path + no_result);
  }
}

/// Of an earlier run, with all that this one's has.
json run_of(const std::string& path, const std::string& text, const json& run) {
  json earlier = parsed(path, text);
  for (const auto& [part, value] : run.items())
    if (!earlier.is_object() || !earlier.contains(part))
      throw StoreError(path +
                       " does not describe a run of tzc-bench paper: give another folder with --output");
  return earlier;
}

}  // namespace

Store::Store(std::string folder) : folder_(std::move(folder)), lock_(-1) {
  try {
    fs::create_directories(path_of("cells"));
    lock_ = lock(folder_);
    remove_unfinished(folder_);
    remove_unfinished(path_of("cells"));
  } catch (const fs::filesystem_error& error) {
    throw StoreError(fmt::format("cannot use the folder {}: {}", folder_, error.code().message()));
  }
}

Store::~Store() {
  ::close(lock_);
}

void Store::write(const std::string& name, const std::string& content) const {
  std::ofstream file(path_of(name) + unfinished, std::ios::binary);
  file << content;
  file.close();
  if (!file) discard(name);
  if (!file) throw StoreError("cannot write " + path_of(name) + ": is the disk full?");
  take(name);
}

void Store::take(const std::string& name) const {
  std::error_code failed;
  fs::rename(path_of(name) + unfinished, path_of(name), failed);
  if (failed) throw StoreError(fmt::format("cannot write {}: {}", path_of(name), failed.message()));
}

void Store::discard(const std::string& name) const {
  std::error_code ignored;
  fs::remove(path_of(name) + unfinished, ignored);
}

std::string Store::read(const std::string& name) const {
  const std::string failure = "cannot read " + path_of(name);
  try {
    std::ifstream file(path_of(name), std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) throw StoreError(failure);
    return text;
  } catch (const std::ios_base::failure&) {  // a folder, or a disk that fails
    throw StoreError(failure);
  }
}

bool Store::has(const std::string& name) const {
  return is_there(path_of(name));
}

bool Store::has_begun(const std::string& folder) {
  return is_there(folder + "/run.json");
}

void Store::begin(const json& run) const {
  if (!has_begun(folder_)) return write("run.json", run.dump(2) + "\n");
  const json earlier = run_of(path_of("run.json"), read("run.json"), run);
  for (const char* part : {"settings", "machine", "versions"}) {
    if (earlier.at(part) == run.at(part)) continue;
    throw StoreError(
        fmt::format("{} holds results of another run ({}: {}, now {}): give another folder with --output",
                    folder_, part, earlier.at(part).dump(), run.at(part).dump()));
  }
}

void Store::remove(const std::string& name) const {
  std::error_code ignored;
  fs::remove(path_of(name), ignored);
}

std::vector<Cell> Store::cells() const {
  std::vector<Cell> cells;
  const std::string folder = path_of("cells");
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string name = "cells/" + entry->path().filename().string();
    if (entry->path().extension() == ".json") cells.push_back(cell_of(path_of(name), read(name)));
  }
  if (failed) throw StoreError(fmt::format("cannot read {}: {}", folder, failed.message()));
  return cells;
}

CellResult Store::load(const Cell& cell) const {
  CellResult result{cell, {}};
  const std::string path = path_of(name_of(cell));
  if (!is_there(path)) return result;
  const json document = parsed(path, read(name_of(cell)));
  try {
    for (const auto& [number, round] : document.at("rounds").items())
      result.rounds.emplace(std::stoul(number), round_of_json(round));
  } catch (const std::exception&) {
    throw StoreError(path + no_result);
  }
  return result;
}

std::vector<CellResult> Store::load(const std::vector<Cell>& cells) const {
  std::vector<CellResult> results;
  for (const Cell& cell : cells) results.push_back(load(cell));
  return results;
}

void Store::save(const CellResult& result) const {
  json document{{"contender", result.cell.contender},
                {"size_bytes", result.cell.size_bytes},
                {"subscribers", result.cell.subscribers},
                {"under_load", result.cell.conditions.load},
                {"real_time", result.cell.conditions.real_time},
                {"rounds", json::object()}};
  for (const auto& [number, round] : result.rounds)
    document["rounds"][std::to_string(number)] = bench::to_json(round);
  write(name_of(result.cell), document.dump() + "\n");
}

json to_json(const Measurement& round) {
  json latencies = json::array();
  for (const auto& one : round.latency_ns) latencies.push_back(to_json(one));
  return {{"seconds", round.seconds},
          {"publisher", to_json(round.publisher)},
          {"subscribers", to_json(round.subscribers)},
          {"latency_ns", std::move(latencies)},
          {"published_ns", round.published_ns}};
}

Measurement round_of_json(const json& json) {
  Measurement round;
  round.outcome = Outcome::complete;
  round.seconds = json.at("seconds");
  round.publisher = cost_of_json(json.at("publisher"));
  round.subscribers = cost_of_json(json.at("subscribers"));
  round.published_ns = json.at("published_ns").get<std::vector<std::int64_t>>();
  for (const auto& one : json.at("latency_ns")) round.latency_ns.push_back(latencies_of_json(one));
  return round;
}

}  // namespace bench
}  // namespace tzc
