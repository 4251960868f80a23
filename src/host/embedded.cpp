#include "host/embedded.hpp"

const std::map<std::string, std::string>& host::embedded() {
  static const std::map<std::string, std::string> all{
#include "embedded_files.txt"
  };
  return all;
}
