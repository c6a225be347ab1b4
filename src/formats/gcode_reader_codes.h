#pragma once

#include <cstdint>

/// What G and M numbers are to the reader. docs/cnc.md has the list.
namespace unstep {

/// LinuxCNC's modal groups: one word of each may stand on a line.
enum class GcodeGroup : std::uint8_t {
  once,  ///< not modal: G4, G10, G28, G92 ...
  motion,
  plane,
  distance,
  arc_distance,
  feed_mode,
  units,
  compensation,
  tool_length,
  coordinate_system,
  path_mode,
  retract,
  spindle_mode,
  machine,  ///< G53, which goes with a motion
  unknown
};

[[nodiscard]] constexpr GcodeGroup gcode_group(int code) {
  switch (code) {
    case 40:
    case 100:
    case 280:
    case 281:
    case 300:
    case 301:
    case 920:
    case 921:
    case 922:
    case 923: return GcodeGroup::once;
    case 0:
    case 10:
    case 20:
    case 30:
    case 330:
    case 331:
    case 382:
    case 383:
    case 384:
    case 385:
    case 730:
    case 760:
    case 800:
    case 810:
    case 820:
    case 830:
    case 840:
    case 850:
    case 860:
    case 870:
    case 880:
    case 890: return GcodeGroup::motion;
    case 170:
    case 180:
    case 190: return GcodeGroup::plane;
    case 900:
    case 910: return GcodeGroup::distance;
    case 901:
    case 911: return GcodeGroup::arc_distance;
    case 930:
    case 940:
    case 950: return GcodeGroup::feed_mode;
    case 200:
    case 210: return GcodeGroup::units;
    case 400:
    case 410:
    case 411:
    case 420:
    case 421: return GcodeGroup::compensation;
    case 430:
    case 431:
    case 432:
    case 490: return GcodeGroup::tool_length;
    case 540:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
    case 591:
    case 592:
    case 593: return GcodeGroup::coordinate_system;
    case 610:
    case 611:
    case 640: return GcodeGroup::path_mode;
    case 980:
    case 990: return GcodeGroup::retract;
    case 960:
    case 970: return GcodeGroup::spindle_mode;
    case 530: return GcodeGroup::machine;
    default: return GcodeGroup::unknown;
  }
}

enum class McodeEffect : std::uint8_t {
  none,           ///< neither position nor modes
  position_lost,  ///< a tool change, motors off
  end,
  absolute_e,
  incremental_e,
  unknown
};

[[nodiscard]] constexpr McodeEffect mcode_effect(int code) {
  switch (code) {
    case 20:
    case 300: return McodeEffect::end;
    case 60:
    case 170:
    case 180:
    case 840: return McodeEffect::position_lost;
    case 820: return McodeEffect::absolute_e;
    case 830: return McodeEffect::incremental_e;
    // LinuxCNC and GRBL: stops, spindle, coolant, overrides, digital outputs.
    case 0:
    case 10:
    case 30:
    case 40:
    case 50:
    case 70:
    case 80:
    case 90:
    case 190:
    case 480:
    case 490:
    case 500:
    case 510:
    case 520:
    case 530:
    case 560:
    case 610:
    case 620:
    case 630:
    case 640:
    case 650:
    case 660:
    case 670:
    case 680:
    case 700:
    case 710:
    case 730:
    // Marlin: temperatures, fan, messages, limits of the planner, reports.
    case 420:
    case 750:
    case 760:
    case 770:
    case 780:
    case 850:
    case 920:
    case 1040:
    case 1050:
    case 1060:
    case 1070:
    case 1080:
    case 1090:
    case 1100:
    case 1110:
    case 1120:
    case 1130:
    case 1140:
    case 1150:
    case 1160:
    case 1170:
    case 1180:
    case 1190:
    case 1200:
    case 1210:
    case 1400:
    case 1410:
    case 1900:
    case 1910:
    case 2000:
    case 2010:
    case 2030:
    case 2040:
    case 2050:
    case 2070:
    case 2080:
    case 2090:
    case 2200:
    case 2210:
    case 3000:
    case 4000:
    case 4860:
    case 5690:
    case 9000:
    case 9070: return McodeEffect::none;
    default: return McodeEffect::unknown;
  }
}

}  // namespace unstep
