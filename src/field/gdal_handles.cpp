// SPDX-License-Identifier: GPL-3.0-or-later
#include "gdal_handles.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>

#include "file_bytes.hpp"
#include "gdal_library.hpp"
#include "selion/core/input_file.hpp"

namespace selion {
namespace {

void CPL_STDCALL keep(CPLErr severity, CPLErrorNum /*number*/, const char* text) {
  auto* messages = static_cast<GdalMessages*>(SELION_GDAL(CPLGetErrorHandlerUserData)());
  if (severity == CE_Failure || severity == CE_Fatal) messages->failures.emplace_back(text);
  if (severity == CE_Warning &&
      std::find(messages->warnings.begin(), messages->warnings.end(), text) == messages->warnings.end())
    messages->warnings.emplace_back(text);
}

std::vector<const char*> trusted_drivers() {
  SELION_GDAL(GDALAllRegister)();
  std::vector<const char*> names;
  for (int i = 0; i < SELION_GDAL(GDALGetDriverCount)(); ++i) {
    const std::string_view name = SELION_GDAL(GDALGetDriverShortName)(SELION_GDAL(GDALGetDriver)(i));
    if (name != "OGR_VRT" && name != "WFS") names.push_back(name.data());
  }
  names.push_back(nullptr);
  return names;
}

}  // namespace

GdalMessages::GdalMessages() { SELION_GDAL(CPLPushErrorHandlerEx)(keep, this); }

GdalMessages::~GdalMessages() {
  SELION_GDAL(CPLPopErrorHandler)();
  SELION_GDAL(CPLErrorReset)();
}

MemoryFolder::MemoryFolder()
    : path_{"/vsimem/selion_" + std::to_string(reinterpret_cast<std::uintptr_t>(this))} {}

MemoryFolder::~MemoryFolder() { SELION_GDAL(VSIRmdirRecursive)(path_.c_str()); }

std::string MemoryFolder::add(const std::string& name, const std::string& bytes) {
  std::string path = path_ + "/" + name;
  // GDAL's interface takes a mutable buffer, but only ever reads this one: files are opened for reading.
  auto* data = reinterpret_cast<GByte*>(const_cast<char*>(bytes.data()));
  SELION_GDAL(VSIFCloseL)(SELION_GDAL(VSIFileFromMemBuffer)(path.c_str(), data, bytes.size(), FALSE));
  return path;
}

std::string gdal_file_bytes(const std::string& path, const std::string& label) {
  VSIStatBufL about{};
  VSILFILE* file =
      SELION_GDAL(VSIStatL)(path.c_str(), &about) == 0 ? SELION_GDAL(VSIFOpenL)(path.c_str(), "rb") : nullptr;
  if (file == nullptr) refuse_unreadable(label);
  const auto size = static_cast<vsi_l_offset>(about.st_size);
  std::string bytes;
  if (size <= kLargestFile_bytes) {
    bytes.resize(size);
    bytes.resize(SELION_GDAL(VSIFReadL)(bytes.data(), 1, bytes.size(), file));
  }
  SELION_GDAL(VSIFCloseL)(file);
  if (size > kLargestFile_bytes) refuse_too_large(label);
  if (bytes.size() < size) refuse_cut_short(label);
  return bytes;
}

unsigned long long gdal_file_size(const std::string& path) {
  VSIStatBufL about{};
  const int found = SELION_GDAL(VSIStatExL)(path.c_str(), &about, VSI_STAT_EXISTS_FLAG | VSI_STAT_SIZE_FLAG);
  return found == 0 ? static_cast<unsigned long long>(about.st_size) : 0;
}

bool gdal_file_exists(const std::string& path) {
  VSIStatBufL about{};
  return SELION_GDAL(VSIStatExL)(path.c_str(), &about, VSI_STAT_EXISTS_FLAG) == 0;
}

const char* const* gdal_drivers() {
  static const std::vector<const char*> drivers = trusted_drivers();
  return drivers.data();
}

}  // namespace selion
