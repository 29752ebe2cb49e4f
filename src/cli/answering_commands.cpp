#include "phrame/cli/command.hpp"

namespace phrame::inline v0::cli {

const CommandTable& answering_commands() {
  static const CommandTable table{
      {"angle", add_angle},
      {"info", add_info},
      {"classify", add_classify},
      {"totals", add_totals},
      {"frames", add_frames},
      {"mtf", add_mtf},
      {"interpolate", add_interpolate},
      {"construct", add_construct},
      {"identify", add_identify},
      {"integrate", add_integrate},
      {"sweep", add_sweep},
      {"offset", add_offset},
      {"envelope", add_envelope},
      {"transform", add_transform},
      {"compile", add_compile},
      {"check", add_check},
      {"certify", add_certify},
      {"verify", add_verify},
      {"prove", add_prove},
      {"page", add_page},
  };
  return table;
}

}  // namespace phrame::cli
