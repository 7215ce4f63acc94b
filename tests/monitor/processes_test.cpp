// SPDX-License-Identifier: BSD-3-Clause
#include "processes.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "statistics/page_writer.h"
#include "support/temp_dir.h"

namespace tzc::monitor {
namespace {

bool is_among(pid_t pid, const std::vector<Node>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](const Node& node) { return node.pid == static_cast<std::uint32_t>(pid); });
}

/// A child that waits until it is killed, at the end of the test.
class Child {
 public:
  template <class Prepare>
  explicit Child(Prepare prepare) {
    int ready[2];
    if (::pipe(ready) != 0) ::abort();
    pid_ = ::fork();
    if (pid_ == 0) {
      prepare();
      if (::write(ready[1], "x", 1) != 1) ::_exit(1);
      for (;;) ::pause();
    }
    char byte = 0;
    EXPECT_EQ(::read(ready[0], &byte, 1), 1);
    ::close(ready[0]);
    ::close(ready[1]);
  }
  ~Child() {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_;
};

TEST(Sample, leaves_out_a_child_with_its_parents_page) {
  const auto page = *statistics::PageWriter::create("/parent");
  page->begin();
  page->publish();
  const Child child([] {});
  const Sample sample = take_sample();
  EXPECT_TRUE(is_among(::getpid(), sample.nodes));
  EXPECT_FALSE(is_among(child.pid(), sample.nodes));
}

/// Any process of the user can have a file of that name.
TEST(Sample, names_a_file_of_the_pages_name_that_is_none) {
  const Child child([] {
    const int file = ::memfd_create(statistics::page_name, MFD_CLOEXEC);
    if (::ftruncate(file, 100) != 0) ::_exit(1);
  });
  const Sample sample = take_sample();
  EXPECT_FALSE(is_among(child.pid(), sample.nodes));
  const std::string expected = "process " + std::to_string(child.pid()) +
                               ": its statistics page is left out: it is not a statistics page";
  EXPECT_NE(std::find(sample.troubles.begin(), sample.troubles.end(), expected), sample.troubles.end());
}

TEST(Sample, shows_a_stopped_process) {
  const Child child([] {
    static const auto page = *statistics::PageWriter::create("/stopped");
    page->begin();
    page->publish();
  });
  const auto state = [&] {
    for (const Node& node : take_sample().nodes)
      if (node.pid == static_cast<std::uint32_t>(child.pid())) return node.state;
    return State::silent;
  };
  EXPECT_EQ(state(), State::running);
  ::kill(child.pid(), SIGSTOP);
  ::waitpid(child.pid(), nullptr, WUNTRACED);
  EXPECT_EQ(state(), State::stopped);
}

template <class Row>
Row row(statistics::RowKind kind) {
  Row made{};
  made.kind = kind;
  return made;
}

/// A node that starts anew meets its topics and peers in another order.
TEST(Sample, has_topics_and_peers_by_name) {
  const auto page = *statistics::PageWriter::create("/sorted");
  page->begin();
  for (const char* name : {"/b", "/a"}) {
    auto topic = row<statistics::TopicRow>(statistics::RowKind::topic);
    statistics::copy_text(topic.topic, name);
    page->add(topic);
    for (const char* subscriber : {"/viewer", "/recorder"}) {
      auto connection = row<statistics::ConnectionRow>(statistics::RowKind::connection);
      statistics::copy_text(connection.subscriber, subscriber);
      page->add(connection);
    }
  }
  page->publish();
  for (const Node& node : take_sample().nodes) {
    if (node.name != "/sorted") continue;
    ASSERT_EQ(node.topics.size(), 2u);
    EXPECT_EQ(node.topics[0].name, "/a");
    EXPECT_EQ(node.topics[1].name, "/b");
    EXPECT_EQ(node.topics[0].connections.at(0).subscriber, "/recorder");
    return;
  }
  FAIL() << "the page was not found";
}

/// The folder of a process in a container, as its host sees it.
TEST(Sample, takes_no_number_of_a_container_for_one_of_this_machine) {
  const auto page = *statistics::PageWriter::create("/contained");
  page->begin();
  auto topic = row<statistics::TopicRow>(statistics::RowKind::topic);
  page->add(topic);
  auto connection = row<statistics::ConnectionRow>(statistics::RowKind::connection);
  connection.pid = 9;
  page->add(connection);
  page->publish();
  const test::TempDir proc;
  const std::string own = std::to_string(::getpid());
  proc.write("1000/status", "Name:\tnode\nNSpid:\t1000\t" + own + "\n");
  proc.write("1000/stat", "1000 (node) S 1\n");
  std::filesystem::create_directory_symlink("/proc/self/fd", proc / "1000/fd");
  proc.write("9/stat", "9 (somebody's editor) T 1\n");
  const Sample sample = take_sample(proc.path());
  ASSERT_EQ(sample.nodes.size(), 1u);
  EXPECT_EQ(sample.nodes[0].pid, 1000u);
  const Connection& seen = sample.nodes[0].topics.at(0).connections.at(0);
  EXPECT_EQ(seen.pid, 0u);
  EXPECT_FALSE(seen.is_stopped);
}

TEST(Sample, of_a_folder_without_processes_is_empty) {
  const Sample sample = take_sample("/proc/no/such/folder");
  EXPECT_TRUE(sample.nodes.empty());
  EXPECT_TRUE(sample.troubles.empty());
}

}  // namespace
}  // namespace tzc::monitor
