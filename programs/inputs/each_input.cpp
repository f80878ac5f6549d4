#include "programs/inputs/each_input.h"

#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <sstream>

#include "clip/base/files.h"
#include "clip/base/memory.h"
#include "clip/base/parallel.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"

namespace displayfile {

namespace {

std::string naming(const std::string& input, const std::string& message) {
  const std::string name = input_name(input);
  return message.starts_with(name) ? message : name + ": " + message;
}

InputResult result_of(const std::string& input, std::size_t k,
                      const std::function<std::string(std::size_t)>& work) {
  try {
    return {work(k), "", ""};
  } catch (const std::bad_alloc&) {
    return {"", naming(input, out_of_memory_message()), ""};
  } catch (const std::exception& e) {
    return {"", naming(input, e.what()), ""};
  }
}

}  // namespace

void for_each_input(std::span<const std::string> inputs, int threads, const std::string& what,
                    const std::function<std::string(std::size_t k)>& work,
                    const std::function<void(std::size_t k, const InputResult&)>& take) {
  std::vector<std::optional<InputResult>> done(inputs.size());
  std::size_t finished = 0, taken = 0;
  std::mutex mutex;
  Progress progress(what);
  in_parallel(threads, inputs.size(), [&](std::size_t k) {
    std::ostringstream warned;
    InputResult result;
    {
      const CollectedWarnings collected(warned);
      result = result_of(inputs[k], k, work);
    }
    result.warnings = warned.str();
    const std::lock_guard lock(mutex);
    done[k] = std::move(result);
    progress.update(++finished, inputs.size());
    for (; taken < done.size() && done[taken]; ++taken) {
      take(taken, *done[taken]);
      *done[taken] = {};
    }
  });
}

}  // namespace displayfile
