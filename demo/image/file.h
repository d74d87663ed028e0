// Private to the writers: what every picture file has in common.
#ifndef TSUYA_DEMO_IMAGE_FILE_H
#define TSUYA_DEMO_IMAGE_FILE_H

#include "image.h"

#include <cstdio>
#include <functional>

namespace tsuya::image {

// Sets `error` to "cannot <what> <path>: <why>." and returns false.
bool fail(std::string &error, const char *what, const std::string &path, const std::string &why);

// Returns why the picture cannot be stored, or an empty string: sizes not positive, or a number of
// values that is not width x height x channels.
std::string defect(const Image &image);

// Writes a file beside `path` through `body`, then renames it to `path`. When `body` returns false
// or anything fails, nothing is left behind and `path` is as it was. `body` sets its `why`.
bool replace_file(const std::string &path,
                  const std::function<bool(std::FILE *file, std::string &why)> &body,
                  std::string &error);

} // namespace tsuya::image

#endif
