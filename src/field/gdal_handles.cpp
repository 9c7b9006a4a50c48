// SPDX-License-Identifier: GPL-3.0-or-later
#include "gdal_handles.hpp"

#include <algorithm>
#include <cstdint>

#include <cpl_error.h>
#include <cpl_vsi.h>

#include "selion/core/error.hpp"

namespace selion {
namespace {

void CPL_STDCALL keep(CPLErr severity, CPLErrorNum /*number*/, const char* text) {
  auto* messages = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
  if (severity == CE_Failure || severity == CE_Fatal) messages->failures.emplace_back(text);
  if (severity == CE_Warning &&
      std::find(messages->warnings.begin(), messages->warnings.end(), text) == messages->warnings.end())
    messages->warnings.emplace_back(text);
}

}  // namespace

GdalMessages::GdalMessages() { CPLPushErrorHandlerEx(keep, this); }

GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

MemoryFolder::MemoryFolder()
    : path_{"/vsimem/selion_" + std::to_string(reinterpret_cast<std::uintptr_t>(this))} {}

MemoryFolder::~MemoryFolder() { VSIRmdirRecursive(path_.c_str()); }

std::string MemoryFolder::add(const std::string& name, const std::string& bytes) {
  std::string path = path_ + "/" + name;
  // GDAL's interface takes a mutable buffer, but only ever reads this one: files are opened for reading.
  auto* data = reinterpret_cast<GByte*>(const_cast<char*>(bytes.data()));
  VSIFCloseL(VSIFileFromMemBuffer(path.c_str(), data, bytes.size(), FALSE));
  return path;
}

std::string file_bytes(const std::string& path, const std::string& label) {
  constexpr vsi_l_offset kMost = vsi_l_offset{1} << 31;
  VSIStatBufL about{};
  VSILFILE* file = VSIStatL(path.c_str(), &about) == 0 ? VSIFOpenL(path.c_str(), "rb") : nullptr;
  if (file == nullptr) throw InputError{label + " cannot be read; check the name and the permissions"};
  const auto size = static_cast<vsi_l_offset>(about.st_size);
  std::string bytes;
  if (size <= kMost) {
    bytes.resize(size);
    bytes.resize(VSIFReadL(bytes.data(), 1, bytes.size(), file));
  }
  VSIFCloseL(file);
  if (size > kMost) throw InputError{label + " is larger than 2 GB; cut out the fields to be planned"};
  if (bytes.size() < size) throw InputError{label + " cannot be read to its end; copy or export it anew"};
  return bytes;
}

bool file_exists(const std::string& path) {
  VSIStatBufL about{};
  return VSIStatExL(path.c_str(), &about, VSI_STAT_EXISTS_FLAG) == 0;
}

}  // namespace selion
