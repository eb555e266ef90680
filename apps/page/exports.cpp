// The engine as a page sees it: functions on numbers and bytes in WebAssembly memory. web/src/page/engine.ts calls
// them.
//
// A function that may fail returns 1 or 0; what it came to, or why it failed, are the answers that stand until the next
// call. Texts handed in lie in memory from `reserve`, which each call takes back.

#include <cstdint>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <quadmatch/io/file.hpp>

#include "session.hpp"

#define PAGE_EXPORT(name) __attribute__((export_name(#name)))
#define PAGE_IMPORT(name) __attribute__((import_module("page"), import_name(#name)))

extern "C" {
PAGE_IMPORT(stage) void page_stage(const char* text, std::size_t size);
PAGE_IMPORT(progress) void page_progress(double done, double most);
PAGE_IMPORT(out_of_memory) void page_out_of_memory();
}

namespace quadmatch::page {
namespace {

/// There is one engine in a worker, and one session in it.
Session& session() {
  static Session session(
      {.stage = [](std::string_view text) { page_stage(text.data(), text.size()); },
       .progress = [](std::size_t done,
                      std::size_t most) { page_progress(static_cast<double>(done), static_cast<double>(most)); }});
  return session;
}

std::vector<std::string>& answers() {
  static std::vector<std::string> answers;
  return answers;
}

/// The file that is being handed in.
FileBytes& incoming() {
  static FileBytes bytes;
  return bytes;
}

/// Bytes from `reserve`, given back in the end.
class Given {
 public:
  Given(char* bytes, std::size_t size) : bytes_(bytes), size_(size) {}
  Given(const Given&) = delete;
  Given& operator=(const Given&) = delete;
  ~Given() { ::operator delete(bytes_); }

  [[nodiscard]] std::string_view view() const { return {bytes_, size_}; }
  [[nodiscard]] std::string text() const { return std::string(view()); }

 private:
  char* bytes_;
  std::size_t size_;
};

int fail(const Error& error) {
  answers().assign(1, error.describe());
  return 0;
}

int succeed(std::vector<std::string> texts) {
  answers() = std::move(texts);
  return 1;
}

int hand_out(Expected<Product> product) {
  if (!product) return fail(product.error());
  return succeed({std::move(product->bytes), std::move(product->summary)});
}

}  // namespace

extern "C" {

/// Memory that runs out below is the end of this engine; the page says so.
PAGE_EXPORT(start) void page_start() { std::set_new_handler(page_out_of_memory); }

/// Room for a text to hand in.
PAGE_EXPORT(reserve) char* page_reserve(std::size_t size) { return static_cast<char*>(::operator new(size)); }

PAGE_EXPORT(answer_count) std::size_t page_answer_count() { return answers().size(); }
PAGE_EXPORT(answer_data) const char* page_answer_data(std::size_t index) { return answers()[index].data(); }
PAGE_EXPORT(answer_size) std::size_t page_answer_size(std::size_t index) { return answers()[index].size(); }
/// Forget the answers, which may be large.
PAGE_EXPORT(forget) void page_forget() { answers() = {}; }

/// Room for the bytes of a file, of which there is one at a time: `read` takes it. 0 where there is none.
PAGE_EXPORT(reserve_file) char* page_reserve_file(std::size_t size) {
  incoming() = {};
  return incoming().resize(size) ? incoming().data() : nullptr;
}

/// Answers: warnings.
PAGE_EXPORT(read) int page_read(std::uint32_t slot, char* name, std::size_t name_size) {
  const Given given_name(name, name_size);
  const FileBytes bytes = std::exchange(incoming(), {});
  Expected<std::vector<std::string>> warnings = session().read(static_cast<Slot>(slot), bytes, given_name.text());
  return warnings ? succeed(*std::move(warnings)) : fail(warnings.error());
}

/// Answers: none.
PAGE_EXPORT(choose) int page_choose(char* name, std::size_t name_size, char* value, std::size_t value_size) {
  const Given given_name(name, name_size), given_value(value, value_size);
  const Expected<void> chosen = session().choose(given_name.view(), given_value.text());
  return chosen ? succeed({}) : fail(chosen.error());
}

/// Answers: the header of a report, and its bytes.
PAGE_EXPORT(match) int page_match() {
  Expected<PackedReport> report = session().match();
  if (!report) return fail(report.error());
  return succeed({std::move(report->header), std::move(report->bytes)});
}

/// Answers: the file.
PAGE_EXPORT(match_file) int page_match_file() {
  Expected<std::string> file = session().match_file();
  return file ? succeed({*std::move(file)}) : fail(file.error());
}

/// Answers: the file, and what was done.
PAGE_EXPORT(transfer) int page_transfer(char* name, std::size_t name_size) {
  return hand_out(session().transferred(Given(name, name_size).text()));
}

/// Answers: the file, and what was done.
PAGE_EXPORT(merge) int page_merge(char* name, std::size_t name_size) {
  return hand_out(session().merged(Given(name, name_size).text()));
}

}  // extern "C"

}  // namespace quadmatch::page
