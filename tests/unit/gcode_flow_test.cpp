#include <gtest/gtest.h>

#include <string>

#include "unstep/program.h"

namespace unstep {
namespace {

/// X of every motion, in mm.
std::string xs(const std::string& text) {
  const Result<Program> program = read_gcode(text, {});
  if (!program) return program.error().message;
  std::string out;
  for (const ProgramMove& move : *program_moves(*program, true)) {
    out += std::to_string(move.end[0] / kProgramUnitsPerMm) + " ";
  }
  return out;
}

std::string flow_error(const std::string& text) {
  GcodeReadOptions options;
  options.strict = true;
  const Result<Program> program = read_gcode(text, options);
  return program ? "none" : program.error().message;
}

TEST(gcode_flow, loops_run_as_often_as_they_say) {
  EXPECT_EQ(xs("#1=0\no1 while [#1 LT 3]\nG1 X#1 F9\n#1=[#1+1]\no1 endwhile\n"),
            "0 1 2 ");
  EXPECT_EQ(xs("#1=9\no1 do\nG1 X#1 F9\n#1=[#1+1]\no1 while [#1 LT 3]\n"),
            "9 ");
  EXPECT_EQ(xs("G91\nO 1 Repeat [2.6]\nG1 X1 F9\no1 end repeat\nX9\n"),
            "1 2 3 12 ");
  EXPECT_EQ(xs("o1 repeat [0]\nG1 X1\no1 endrepeat\nN7 o2 while [0]\nG1 X2\n"
               "o2 endwhile\nG0 X3\n"),
            "3 ");
}

TEST(gcode_flow, half_a_turn_more_is_one_to_the_even_number) {
  for (const auto& [count, turns] :
       {std::pair{"0.5", 0}, {"0.51", 1}, {"1.5", 2}, {"2.5", 2}, {"-1", 0}}) {
    const std::string loop = std::string("o1 repeat [") + count + "]\n";
    EXPECT_EQ(xs("#5=0\n" + loop + "#5=[#5+1]\no1 endrepeat\nG0 X#5\n"),
              std::to_string(turns) + " ");
  }
}

TEST(gcode_flow, break_and_continue_are_of_the_loop_they_name) {
  EXPECT_EQ(xs("#1=0\no1 while [1]\n#1=[#1+1]\no2 repeat [5]\no3 if [#1 EQ 2]\n"
               "o1 continue\no3 elseif [#1 EQ 4]\no1 break\no3 endif\n"
               "G0 X#1\no2 break\nG0 X70\no2 endrepeat\no1 endwhile\nG0 X9\n"),
            "1 3 9 ");
}

TEST(gcode_flow, labels_of_every_line_may_be_expressions) {
  EXPECT_EQ(xs("o[3+4] if [0]\nG0 X1\no[14/2] elseif [0]\nG0 X2\no7 else\n"
               "G0 X3\no[7] endif\n#5=0\no[1] while [#5 LT 2]\n#5=[#5+1]\n"
               "o[3-1] repeat [1]\nG0 X#5\no[2] endrepeat\no[1] endwhile\n"
               "o[50*2] sub\nG0 X9\no[100] endsub\n#6=100\no#6 call\n"),
            "3 1 2 9 ");
  EXPECT_EQ(flow_error("#1=7\no#1 if [0]\nG0 X1\no#1 endif\n"),
            "line 2: a label of endif that depends on parameters is not "
            "understood");
}

TEST(gcode_flow, one_branch_is_carried_out) {
  for (int n = 1; n <= 4; ++n) {
    EXPECT_EQ(xs("#1=" + std::to_string(n) +
                 "\no1 if [#1 EQ 1]\nG0 X1\no1 elseif [#1 EQ 2]\nG0 X2\n"
                 "o1 elseif [#1 EQ 3]\nG0 X3\no1 else\nG0 X4\no1 endif\nX5\n"),
              std::to_string(n) + " 5 ");
  }
  EXPECT_EQ(xs("o1 if [0]\nbroken (\no1 endif\nG0 X1\n"), "1 ");
}

TEST(gcode_flow, subroutines_have_arguments_and_names_of_their_own) {
  EXPECT_EQ(xs("#1=7 #<a>=8 #<_g>=1\no<My Sub> sub\nG0 X#1\nX[#2+#30]\n"
               "X[EXISTS[#<a>]]\n#1=50 #<a>=60 #<_g>=[#<_g>+1]\n"
               "o<mysub> endsub [#1+1]\no<mysub> call [3] [4]\nX#1\nX#<a>\n"
               "X#<_g>\nX#<_value>\nX#<_value_returned>\n"),
            "3 4 0 7 8 2 51 1 ");
  EXPECT_EQ(xs("o1 call [3]\nG0 X9\nM2\no1 sub\no2 if [#1 LE 0]\no1 return\n"
               "o2 endif\nG0 X#1\no1 call [#1-1]\nX[#1*10]\no1 endsub\n"),
            "3 2 1 10 20 30 9 ");
  EXPECT_EQ(xs("G0 X#<_value>\no1 sub\no1 endsub [5]\no2 sub\no1 call\n"
               "X#<_value>\no2 endsub\no2 call\nX#<_value>\n"),
            "0 5 0 ");
  // As LinuxCNC 2.9: a definition sets the value too, and a call keeps it.
  EXPECT_EQ(xs("#1=0\no1 sub\nG0 X#<_value>\nX[#<_value_returned>+10]\n"
               "o1 endsub [#1+5]\no1 call [3]\n#1=2\no2 sub\no2 endsub [#1]\n"
               "o1 call [1]\nG0 X[#<_value>+20]\n"),
            "5 11 2 11 26 ");
}

TEST(gcode_flow, lines_that_stay_text_have_their_values) {
  const Result<Program> program = read_gcode(
      "o1 sub\nM3 S[#1*100] (fast)\n#5=#1\nG1 X#1 F100 M8\no1 endsub\n"
      "o1 call [2]\no1 call [3]\nM2\n",
      {});
  ASSERT_TRUE(program) << program.error().message;
  EXPECT_EQ(*write_gcode(*program, {}),
            "M3 S200 (fast)\nG1 M8 F100 X2\nM3 S300 (fast)\nG1 M8 F100 X3\n"
            "M2\n");
}

TEST(gcode_flow, what_the_control_decides_is_kept_or_refused) {
  for (const std::string text :
       {"o1 if [#5221 GT 0]\nG1 X2 F9\no1 endif\nM2\n",
        "o1 call [1]\nG1 X2 F9\nM2\n", "o1 alarm [1]\nG1 X2 F9\nM2\n",
        "/o1 if [0]\nG1 X2 F9\no1 endif\nM2\n",
        "#<_here>=1\no1 repeat [2]\nG1 X#5420 F9\no1 endrepeat\nM2\n",
        "o1 do\no1 continue\nG1 X1\no1 while [0]\n"}) {
    const Result<Program> program = read_gcode("G0 X1\n" + text, {});
    ASSERT_TRUE(program) << program.error().message;
    const Result<std::string> out = write_gcode(*program, {});
    ASSERT_TRUE(out);
    EXPECT_TRUE(out->starts_with("G0 X1\n" + text)) << *out;
    EXPECT_GE(program->notes.size(), 1U);
    const std::string error = flow_error("G0 X1\n" + text);
    EXPECT_TRUE(error.starts_with("line ") &&
                error.ends_with("is not understood"))
        << error;
  }
  GcodeReadOptions keep;
  keep.execute_flow = false;
  const Result<Program> kept = read_gcode("o1 repeat [2]\nG0 X1\n", keep);
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->items[1].unknown_effect);
}

TEST(gcode_flow, errors_name_the_line) {
  const auto expect = [](const std::string& text, const std::string& error) {
    EXPECT_EQ(xs(text), error) << text;
  };
  expect("G0 X1\no1 while [1]\n", "line 2: o1 while has no end");
  expect("o1 while [0]\n", "line 1: o1 while without endwhile");
  expect("o1 endwhile\n", "line 1: o1 endwhile without while");
  expect("o1 else\n", "line 1: o1 else without if");
  expect("o1 repeat [1]\no2 endrepeat\n",
         "line 2: o2 endrepeat without repeat");
  expect("o1 break\n", "line 1: o1 break without a loop");
  expect("o<a> sub\n", "line 1: o<A> sub without endsub");
  expect("\no1 return\n", "line 2: o1 return without a call of it");
  expect("o1 if 1\n", "line 1: expected \"[\"");
  expect("o1 if [1] G0 X1\n",
         "line 1: more on a line of if than belongs to it");
  expect("o1 sub\no1 call\no1 endsub\no1 call\n",
         "line 2: calls are nested more than 64 deep");
}

TEST(gcode_flow, a_loop_without_end_is_refused_by_a_limit) {
  GcodeReadOptions options;
  options.limits.max_executed_lines = 1000;
  const Result<Program> program =
      read_gcode("G0 X1\no1 while [1]\nG0 X2\no1 endwhile\n", options);
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().code, ErrorCode::limit_exceeded);
  EXPECT_EQ(program.error().message,
            "line 4: more than the limit of 1000 lines carried out: a loop may "
            "have no end");
}

TEST(gcode_flow, numbers_that_are_nearly_equal_are) {
  EXPECT_EQ(xs("#1=0\no1 while [#1 NE 1]\n#1=[#1+0.1]\no1 endwhile\n"
               "G0 X[#1*10]\nX[1.00005 EQ 1]\nX[1.00005 GT 1]\n"),
            "10 1 1 ");
}

}  // namespace
}  // namespace unstep
