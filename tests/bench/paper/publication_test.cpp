// SPDX-License-Identifier: BSD-3-Clause
#include "paper/publication.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "temp_dir.h"

namespace {

using namespace tzc::bench;
using tzc::test::TempDir;

TEST(Publication, has_what_a_repository_shows_and_no_raw_samples) {
  const TempDir results, repository;
  const Store store(results.path());
  for (const char* name :
       {"README.md", "a.csv", "a.svg", "a.png", "run.json", "results.json", "cells/a.json", "a.gnuplot"})
    store.write(name, name);
  repository.write("docs/figures/README.md", "of before");
  publish(store, repository / "docs/figures");
  for (const char* name : {"README.md", "a.csv", "a.svg", "a.png", "run.json"})
    EXPECT_EQ(repository.read(std::string("docs/figures/") + name), name);
  for (const char* name : {"results.json", "cells", "a.gnuplot"})
    EXPECT_FALSE(std::filesystem::exists(repository / "docs/figures/" + name)) << name;
}

TEST(Publication, says_where_it_cannot_write) {
  const TempDir results, repository;
  const Store store(results.path());
  repository.write("file", "");
  EXPECT_THROW(publish(store, repository / "file"), StoreError);
}

}  // namespace
