#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/gcode_flow_word.h"
#include "formats/gcode_parameters.h"
#include "unstep/result.h"

/// Subroutines, loops and branches of LinuxCNC ("O codes"): which line comes
/// after which. Labels pair the words, as in LinuxCNC; what stands between is
/// looked for once and remembered.
namespace unstep {

/// Where a line begins.
struct GcodePlace {
  std::size_t at = 0;
  std::uint32_t line = 1;
};

class GcodeFlow {
 public:
  static constexpr std::size_t kMaxCalls = 64;

  /// The text must outlive the flow.
  explicit GcodeFlow(std::string_view text) : text_(text) {}

  /// Carries out the word of the line at `here`, after which the text goes on
  /// at `next`. Where the program goes on. corrupt for words that do not pair,
  /// limit_exceeded for calls, unsupported where what is not in the program
  /// decides. Messages have no line number but may name others.
  Result<GcodePlace> run(const GcodeFlowWord& word, GcodePlace here,
                         GcodePlace next, GcodeParameters& parameters);

  /// What is open at the end of the text: corrupt.
  [[nodiscard]] Status finish() const;

 private:
  using Key = GcodeFlowKey;
  using Keys = std::initializer_list<Key>;
  struct Open {
    Key key = Key::loop;
    std::string label;
    std::uint32_t line = 0;
    GcodePlace begin;        ///< loops: where the next turn begins
    std::int64_t turns = 0;  ///< of repeat, left
    bool taken = false;      ///< if: a branch was carried out
  };
  struct Call {
    std::string label;
    GcodePlace back;
    std::size_t open = 0;  ///< how much was open at the call
  };
  struct Found {
    GcodePlace here;
    GcodePlace next;
  };

  Result<GcodePlace> run_loop(const GcodeFlowWord& word, GcodePlace here,
                              GcodePlace next);
  Result<GcodePlace> run_while(const GcodeFlowWord& word, GcodePlace here,
                               GcodePlace next);
  Result<GcodePlace> run_branch(const GcodeFlowWord& word, GcodePlace here,
                                GcodePlace next);
  Result<GcodePlace> run_jump(const GcodeFlowWord& word, GcodePlace next);
  Result<GcodePlace> enter(const GcodeFlowWord& word, GcodePlace next,
                           GcodeParameters& parameters);
  Result<GcodePlace> leave(const GcodeFlowWord& word,
                           GcodeParameters& parameters);
  Result<GcodePlace> define(const GcodeFlowWord& word, GcodePlace next,
                            GcodeParameters& parameters);
  static void set_value(const GcodeFlowWord& word, GcodeParameters& parameters);
  Result<Found> find_end(const Open& open, GcodePlace from);
  Result<Found> find(const GcodeFlowWord& word, GcodePlace from, Keys keys);
  void find_subs();
  void push(Key key, const GcodeFlowWord& word, GcodePlace here,
            GcodePlace begin);
  /// The innermost of this call with one of the keys; what is inside of it
  /// ends. Null if there is none.
  Open* innermost(const std::string& label, Keys keys);

  std::string_view text_;
  std::vector<Open> open_;
  std::vector<Call> calls_;
  std::string defined_;  ///< the subroutine whose lines are passed over
  bool subs_found_ = false;
  std::map<std::string, GcodePlace> subs_;  ///< where their bodies begin
  /// By the place a search begins at and what it is for.
  std::map<std::pair<std::size_t, std::uint32_t>, Found> found_;
};

}  // namespace unstep
