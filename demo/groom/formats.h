// Private to the readers: one function a file format. `options` are checked.
#ifndef TSUYA_GROOM_FORMATS_H
#define TSUYA_GROOM_FORMATS_H

#include "bytes.h"
#include "read.h"

namespace tsuya::groom {

Result read_tfx(const Bytes &file, const ReadOptions &options);
Result read_hair(const Bytes &file, const ReadOptions &options);
Result read_data(const Bytes &file, const ReadOptions &options);

} // namespace tsuya::groom

#endif
