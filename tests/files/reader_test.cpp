#include <fcntl.h>
#include <fmt/core.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>

#include "files.h"
#include "presets/error.h"
#include "render/files/load.h"
#include "render/files/open_choice.h"
#include "render/files/reader_process.h"
#include "tests/paths.h"

namespace crest::test {
namespace {

/// What a reader that fails in some way is to the program (reader/bad_reader.cpp).
class FailingReader : public FileTest {
 protected:
  std::string error_of(const std::string& what,
                       std::chrono::seconds patience = std::chrono::seconds(60)) const {
    Reading reading;
    reading.reader = bad_reader_program();
    reading.patience = patience;
    return error_of(what, reading);
  }
  std::string error_of(const std::string& what, const Reading& reading,
                       const std::string& name = "v.nrrd") const {
    const std::string file = write(name, "the reader does not read it");
    try {
      load_volume(file + "?do=" + what, reading);
    } catch (const Error& error) {
      const std::string text = error.what();
      return text.starts_with(file + ": ") ? text.substr(file.size() + 2) : text;
    }
    return "read";
  }
};

TEST_F(FailingReader, OneThatDoesWellIsRead) { EXPECT_EQ(error_of("well"), "read"); }

TEST_F(FailingReader, ValuesAreTakenAsTheyAreStored) {
  const std::string file = write("v.nrrd", "");
  const Volume volume = load_volume(file + "?do=stored", {.reader = bad_reader_program()});
  EXPECT_FALSE(volume.values.are_floats());
  EXPECT_EQ(volume.at(1, 0, 0), 2 * 'b' - 1.F);
  EXPECT_EQ(error_of("half stored"), "its reader failed (it ended before its answer did)");
  EXPECT_EQ(load_volume(file + "?do=part", {.reader = bad_reader_program()}).part->full, glm::u64vec3(4));
}

TEST_F(FailingReader, HowMuchIsReadIsTold) {
  const std::string file = write("v.nrrd", "");
  std::vector<double> shares;
  Reading reading;
  reading.reader = bad_reader_program();
  reading.progress = [&](double share) { shares.push_back(share); };
  load_volume(file + "?do=told", reading);
  ASSERT_GE(shares.size(), 6u);
  EXPECT_TRUE(std::ranges::is_sorted(shares)) << "also where it went backward";
  EXPECT_EQ(shares[0], 0);
  EXPECT_NEAR(shares[1], shares[4] / 4, 1e-12);
  EXPECT_GT(shares[5], shares[4]) << "the values are on their way";
  EXPECT_EQ(shares.back(), 1);
}

TEST_F(FailingReader, ItsEndIsAnError) {
  EXPECT_EQ(error_of("abort"), "its reader failed (signal 6, Aborted)");
#ifndef __SANITIZE_ADDRESS__  // which makes it exit code 1
  EXPECT_EQ(error_of("crash"), "its reader failed (signal 11, Segmentation fault)");
#endif
  Reading reading;
  reading.reader = bad_reader_program();
  EXPECT_EQ(error_of("abort", reading, "v.dcm"),
            "its reader failed (GDCM ended: signal 6, Aborted; the file is damaged, or of a kind that GDCM "
            "cannot read)");
  EXPECT_EQ(error_of("leave"), "its reader failed (exit code 7)");
  EXPECT_EQ(error_of("nothing"), "its reader failed (it ended before its answer did)");
}

TEST_F(FailingReader, ALoopIsEnded) {
  EXPECT_EQ(error_of("loop"), "its reader failed (it took longer than 1 s of processor time)");  // as it told
  for (const char* what : {"sleep", "drip", "repeat"})
    EXPECT_EQ(error_of(what, std::chrono::seconds(1)), "its reader failed (it took longer than 1 s)") << what;
}

TEST_F(FailingReader, OneThatIsStoppedIsEnded) {
  EXPECT_EQ(error_of("stop", std::chrono::seconds(1)), "its reader failed (it was stopped by a signal)");
}

TEST_F(FailingReader, MemoryHasAnEnd) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer needs the address space";
#endif
  EXPECT_EQ(error_of("allocate"),
            "its reader failed (signal 6, Aborted)");  // as what it threw was not caught
}

TEST_F(FailingReader, AnAnswerIsHeldAgainstItself) {
  for (const char* what : {"short", "unfinished"})
    EXPECT_EQ(error_of(what), "its reader failed (it ended before its answer did)") << what;
  for (const char* what :
       {"garbage", "deep",   "endless",     "count",      "negative",    "flat",         "spacing",
        "other",   "wide",   "raw",         "doubles",    "no slope",    "other part",   "no stride",
        "frame",   "frames", "told beyond", "told below", "told a word", "told nothing", "told too often"})
    EXPECT_EQ(error_of(what), "its reader failed (its answer makes no sense)") << what;
  EXPECT_NE(error_of("huge").find("memory"), std::string::npos) << error_of("huge");
}

TEST_F(FailingReader, WhatIsShownOrOpenedNextIsNotItsToSay) {
  Reading reading;
  reading.reader = bad_reader_program();
  const std::string file = write("v.nrrd", "the reader does not read it");
  const std::string note = load_volume(file + "?do=note", reading).note;
  EXPECT_TRUE(note.starts_with("a\\x1b[31m")) << note.substr(0, 100);
  EXPECT_LT(note.size(), 5000U);
  try {
    load_volume(file + "?do=choice", reading);
    ADD_FAILURE() << "there was no choice";
  } catch (const ChoiceNeeded& needed) {
    EXPECT_EQ(chosen_source(needed.choice, 0), file + "?do=choice&frame=0");
    EXPECT_EQ(needed.choice.options[0].text, "a\\x1b[31mb");
  }
}

TEST_F(FailingReader, OneThatIsNotThereIsSaid) {
  Reading reading;
  reading.reader = path("no reader");
  EXPECT_NE(error_of("well", reading).find("cannot be started: No such file"), std::string::npos);
}

TEST_F(FailingReader, IsEndedWhenNobodyWantsTheFile) {
  std::stop_source stop;
  Reading reading;
  reading.reader = bad_reader_program();
  reading.patience = std::chrono::seconds(600);
  reading.stop = stop.get_token();
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop.request_stop();
  });
  EXPECT_EQ(error_of("sleep", reading), "reading it was stopped");
  other.join();
}

TEST_F(FailingReader, CanReadFilesAndNoMore) {
  // The kernel itself is asked: without a program it finds a bad address where it takes filters at all
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr) == 0 || errno != EFAULT)
    GTEST_SKIP() << "this system has no seccomp filters";
  EXPECT_EQ(error_of("doors"), "doors:");
  EXPECT_TRUE(std::filesystem::exists(path("v.nrrd")));
}

TEST_F(FailingReader, InheritsNothingThatIsOpen) {
  // Where it did, the pipe would stay open while the reader sleeps.
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  std::stop_source stop;
  Reading reading;
  reading.reader = bad_reader_program();
  reading.patience = std::chrono::seconds(600);
  reading.stop = stop.get_token();
  std::thread other([&] { error_of("sleep", reading); });
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  close(ends[1]);
  char byte = 0;
  EXPECT_EQ(read(ends[0], &byte, 1), 0);
  close(ends[0]);
  stop.request_stop();
  other.join();
}

/// What the reader's program tells that it sets about.
class Expectations : public FileTest {
 protected:
  /// The greatest number of bytes.
  static double of(const std::vector<std::string>& words) {
    const ReaderProcess process(reader_program(), words);
    std::string answer;
    char block[4096];
    for (ssize_t got = 0; (got = ::read(process.output(), block, sizeof block)) > 0;)
      answer.append(block, std::size_t(got));
    const std::string key = "\"expects\":";
    double greatest = 0;
    for (std::size_t at = 0; (at = answer.find(key, at)) != std::string::npos; at += key.size())
      greatest = std::max(greatest, std::stod(answer.substr(at + key.size(), 20)));
    EXPECT_NE(answer.find("\"volume\""), std::string::npos) << answer;
    return greatest;
  }
  static constexpr const char* memory = "1000000000";
};

TEST_F(Expectations, CountTheFilesBesides) {
  const std::string skipped(1000000, 'x');
  write("v.raw", skipped + std::string(60, 'v'));
  const std::string header = write("v.nhdr",
                                   "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 4 3\nencoding: raw\n"
                                   "byte skip: 1000000\ndata file: v.raw\n");
  EXPECT_GT(of({"nrrd", memory, "decides", header}), 1000060.);
}

TEST_F(Expectations, CountWhatIsInflatedToFindAPart) {
  const std::string film = write("film.nrrd",
                                 "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 5 4 3 20000\n"
                                 "kinds: space space space time\nencoding: gzip\n\n" +
                                     gzip(std::string(1200000, 'v')));
  EXPECT_GT(of({"nrrd", memory, "decides", film, "frame=0"}), 1200000.);
}

}  // namespace
}  // namespace crest::test
