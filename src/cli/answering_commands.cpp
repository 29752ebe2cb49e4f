#include "phrame/cli/command.hpp"

namespace phrame::cli {

const std::vector<AddCommand>& answering_commands() {
  static const std::vector<AddCommand> list{
      add_angle,       add_info,      add_classify, add_totals,    add_frames, add_mtf,
      add_interpolate, add_construct, add_identify, add_integrate, add_sweep,  add_offset,
      add_compile,     add_check,     add_certify,  add_verify,    add_prove,  add_page};
  return list;
}

}  // namespace phrame::cli
