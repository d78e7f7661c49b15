#include <algorithm>

#include "extras/sweep/merge.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "report/study/sibling_program.hpp"

#ifdef ODDITY_HDF5
#include <hdf5.h>
#endif

namespace oddity::sweep {

#ifdef ODDITY_HDF5

namespace {

/// An open object of HDF5, and how to close it.
class Open {
 public:
  Open(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
    if (id < 0) throw BadInput("HDF5 cannot make " + what);
  }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;
  ~Open() { close_(id_); }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t status, const std::string& what) {
  if (status < 0) throw BadInput("HDF5 cannot make " + what + ": is there not enough memory?");
}

template <class T>
void add_dataset(hid_t file, const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
                 const std::vector<T>& values) {
  const Open space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, name);
  const Open how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
  H5Pset_obj_track_times(how, false);  // equal cells give equal files
  H5Pset_chunk(how, static_cast<int>(shape.size()), shape.data());
  H5Pset_shuffle(how);
  H5Pset_deflate(how, 6);
  const Open set(H5Dcreate(file, name.c_str(), type, space, H5P_DEFAULT, how, H5P_DEFAULT), H5Dclose, name);
  require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
}

void add_text(hid_t to, const std::string& name, const std::string& text) {
  const Open type(H5Tcopy(H5T_C_S1), H5Tclose, name);
  H5Tset_size(type, text.size() + 1);
  H5Tset_cset(type, H5T_CSET_UTF8);
  const Open space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Open attribute(H5Acreate(to, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  require(H5Awrite(attribute, type, text.c_str()), name);
}

void add_axis(hid_t file, const Axis& axis, const std::string& name) {
  std::vector<double> values;
  for (int cell = 0; cell < axis.count; ++cell) values.push_back(axis.at(cell));
  add_dataset(file, name, H5T_NATIVE_DOUBLE, {values.size()}, values);
  const Open set(H5Dopen(file, name.c_str(), H5P_DEFAULT), H5Dclose, name);
  add_text(set, "name", axis.name);
  add_text(set, "unit", axis.unit);
}

void add_all(hid_t file, const Map& map) {
  const std::vector<hsize_t> shape{static_cast<hsize_t>(map.height), static_cast<hsize_t>(map.width)};
  add_dataset(file, "ended", H5T_NATIVE_UINT16, shape, map.ended);
  add_dataset(file, "error", H5T_NATIVE_DOUBLE, shape, map.error);
  add_dataset(file, "evaluations", H5T_NATIVE_DOUBLE, shape, map.evaluations);
  add_dataset(file, "looked", H5T_NATIVE_UINT8, shape, map.looked);
  add_axis(file, map.asked.axes[0], "x");
  if (map.asked.axes.size() == 2) add_axis(file, map.asked.axes[1], "y");
  std::string names;
  for (const std::string& name : map.endings) names += (names.empty() ? "" : "\n") + name;
  add_text(file, "endings", names);
  add_text(file, "fingerprint", map.fingerprint);
  add_text(file, "asked", to_json(map.asked));
  add_text(file, "summary", summary(map));
}

/// The bytes of the file, which HDF5 makes in memory: it does not always report a full disk.
std::string bytes_of(hid_t file) {
  require(H5Fflush(file, H5F_SCOPE_LOCAL), "a file in memory");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  std::string bytes(static_cast<std::size_t>(std::max<ssize_t>(size, 0)), '\0');
  require(size > 0 && H5Fget_file_image(file, bytes.data(), bytes.size()) == size ? 0 : -1,
          "a file in memory");
  return bytes;
}

}  // namespace

void write_hdf5(const Map& map, const std::filesystem::path& file) {
  H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
  const Open access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, file.string());
  require(H5Pset_fapl_core(access, 1 << 20, false), file.string());
  const Open open(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, file.string());
  add_all(open, map);
  write_whole(file, bytes_of(open));
}

#else

void write_hdf5(const Map&, const std::filesystem::path& file) {
  throw BadInput("this program is built without HDF5, and cannot write " + file.string() + ": " +
                 where_to_build() +
                 "'./oddity sweep merge' installs it and builds with it, or ask for a .csv");
}

#endif

}  // namespace oddity::sweep
