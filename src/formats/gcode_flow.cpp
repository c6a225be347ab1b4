#include "formats/gcode_flow.h"

#include <algorithm>
#include <cmath>

namespace unstep {
namespace {

using Key = GcodeFlowKey;

std::string written(const GcodeFlowKey key, const std::string& label) {
  std::string text = "o";
  text += label;
  if (label.starts_with('<')) text += '>';
  text += ' ';
  text += flow_key_name(key);
  return text;
}

Error without(const GcodeFlowWord& word, std::string_view other) {
  return {ErrorCode::corrupt,
          written(word.key, word.label) + " without " + std::string(other)};
}

/// Calls take(word, its line, the line after) until that returns false.
template <class Take>
void visit_flow_lines(std::string_view text, GcodePlace from, Take&& take) {
  for (GcodePlace here = from; here.at < text.size();) {
    const std::size_t end = std::min(text.find('\n', here.at), text.size());
    const GcodePlace next{end + 1, here.line + 1};
    const GcodeFlowWord word =
        find_flow_word(text.substr(here.at, end - here.at));
    if (word.key != Key::unknown && !take(word, here, next)) return;
    here = next;
  }
}

bool is_true(const GcodeFlowWord& word) { return word.numbers[0] != 0; }

/// Words that only count where they are carried out need their numbers.
Error not_known(const GcodeFlowWord& word) {
  return {ErrorCode::unsupported,
          written(word.key, word.label) +
              " of a parameter that the program does not set"};
}

}  // namespace

Result<GcodePlace> GcodeFlow::run(const GcodeFlowWord& word, GcodePlace here,
                                  GcodePlace next,
                                  GcodeParameters& parameters) {
  if (!defined_.empty()) return define(word, next, parameters);
  if (!word.known && word.key != Key::elseif) return not_known(word);
  switch (word.key) {
    case Key::unknown:
      return Error{ErrorCode::unsupported,
                   "an O word that is not one of LinuxCNC"};
    case Key::sub: {
      const Result<Found> end = find(word, next, {Key::back, Key::endsub});
      if (!end) return end.error();
      defined_ = word.label;
      return end->here;
    }
    case Key::call: return enter(word, next, parameters);
    case Key::endsub:
    case Key::back: return leave(word, parameters);
    case Key::loop:
    case Key::endwhile:
    case Key::repeat:
    case Key::endrepeat: return run_loop(word, here, next);
    case Key::check_while: return run_while(word, here, next);
    case Key::check_if:
    case Key::elseif:
    case Key::otherwise:
    case Key::endif: return run_branch(word, here, next);
    case Key::leave:
    case Key::next: break;
  }
  return run_jump(word, next);
}

Status GcodeFlow::finish() const {
  if (open_.empty()) return {};
  const Open& last = open_.back();
  return Error{ErrorCode::corrupt, "line " + std::to_string(last.line) + ": " +
                                       written(last.key, last.label) +
                                       " has no end"};
}

Result<GcodePlace> GcodeFlow::run_loop(const GcodeFlowWord& word,
                                       GcodePlace here, GcodePlace next) {
  if (word.key == Key::loop) {
    push(Key::loop, word, here, next);
    return next;
  }
  if (word.key == Key::endwhile) {
    const Open* open = innermost(word.label, {Key::check_while});
    return open != nullptr ? Result<GcodePlace>(open->begin)
                           : without(word, "while");
  }
  if (word.key == Key::endrepeat) {
    Open* open = innermost(word.label, {Key::repeat});
    if (open == nullptr) return without(word, "repeat");
    if (--open->turns > 0) return open->begin;
    open_.pop_back();
    return next;
  }
  // Halves to the even number, as LinuxCNC.
  const double turns = std::nearbyint(word.numbers[0]);
  if (turns < 1) {
    const Result<Found> end = find(word, next, {Key::endrepeat});
    return end ? Result<GcodePlace>(end->next) : end.error();
  }
  push(Key::repeat, word, here, next);
  open_.back().turns = static_cast<std::int64_t>(std::min(turns, 9e18));
  return next;
}

/// The head of a loop, or the end of one that begins with do.
Result<GcodePlace> GcodeFlow::run_while(const GcodeFlowWord& word,
                                        GcodePlace here, GcodePlace next) {
  const Open* open = innermost(word.label, {Key::loop, Key::check_while});
  if (open != nullptr && open->key == Key::loop) {
    if (is_true(word)) return open->begin;
    open_.pop_back();
    return next;
  }
  if (is_true(word)) {
    if (open == nullptr) push(Key::check_while, word, here, here);
    return next;
  }
  if (open != nullptr) open_.pop_back();
  const Result<Found> end = find(word, next, {Key::endwhile});
  return end ? Result<GcodePlace>(end->next) : end.error();
}

Result<GcodePlace> GcodeFlow::run_branch(const GcodeFlowWord& word,
                                         GcodePlace here, GcodePlace next) {
  Open* open = nullptr;
  if (word.key == Key::check_if) {
    push(Key::check_if, word, here, here);
    open = &open_.back();
  } else {
    open = innermost(word.label, {Key::check_if});
    if (open == nullptr) return without(word, "if");
  }
  if (word.key == Key::endif) {
    open_.pop_back();
    return next;
  }
  if (open->taken) {
    const Result<Found> end = find(word, next, {Key::endif});
    return end ? Result<GcodePlace>(end->here) : end.error();
  }
  if (!word.known) return not_known(word);
  open->taken = word.key == Key::otherwise || is_true(word);
  if (open->taken) return next;
  const Result<Found> other =
      find(word, next, {Key::elseif, Key::otherwise, Key::endif});
  return other ? Result<GcodePlace>(other->here) : other.error();
}

/// break and continue.
Result<GcodePlace> GcodeFlow::run_jump(const GcodeFlowWord& word,
                                       GcodePlace next) {
  const Open* open =
      innermost(word.label, {Key::loop, Key::check_while, Key::repeat});
  if (open == nullptr) return without(word, "a loop");
  if (word.key == Key::next && open->key == Key::check_while) {
    return open->begin;
  }
  // LinuxCNC 2.9 then forgets do loops that are open, against its manual;
  // others do not. Leaving the do loop itself is the same everywhere.
  const bool leaves_do = word.key == Key::leave && open->key == Key::loop;
  const auto in_do =
      std::count_if(open_.begin(), open_.end(),
                    [](const Open& other) { return other.key == Key::loop; });
  if (in_do > (leaves_do ? 1 : 0)) {
    return Error{ErrorCode::unsupported,
                 written(word.key, word.label) + " in a do loop"};
  }
  const Result<Found> end = find_end(*open, next);
  if (!end) return end.error();
  // The last line of repeat says whether there is another turn.
  if (word.key == Key::next) return end->here;
  open_.pop_back();
  return end->next;
}

Result<GcodeFlow::Found> GcodeFlow::find_end(const Open& open,
                                             GcodePlace from) {
  GcodeFlowWord word;
  word.key = open.key;
  word.label = open.label;
  switch (open.key) {
    case Key::loop: return find(word, from, {Key::check_while});
    case Key::repeat: return find(word, from, {Key::endrepeat});
    default: return find(word, from, {Key::endwhile});
  }
}

Result<GcodePlace> GcodeFlow::enter(const GcodeFlowWord& word, GcodePlace next,
                                    GcodeParameters& parameters) {
  if (!subs_found_) find_subs();
  const auto found = subs_.find(word.label);
  if (found == subs_.end()) {
    return Error{ErrorCode::unsupported, written(word.key, word.label) +
                                             " of what is not in the program"};
  }
  if (calls_.size() == kMaxCalls) {
    return Error{
        ErrorCode::limit_exceeded,
        "calls are nested more than " + std::to_string(kMaxCalls) + " deep"};
  }
  parameters.enter(word.numbers);
  calls_.push_back({word.label, next, open_.size()});
  return found->second;
}

Result<GcodePlace> GcodeFlow::leave(const GcodeFlowWord& word,
                                    GcodeParameters& parameters) {
  if (calls_.empty() || calls_.back().label != word.label) {
    return without(word, "a call of it");
  }
  parameters.leave();
  set_value(word, parameters);
  const GcodePlace back = calls_.back().back;
  open_.resize(calls_.back().open);
  calls_.pop_back();
  return back;
}

/// Of a subroutine that is only defined LinuxCNC evaluates what its lines of
/// return and endsub say.
Result<GcodePlace> GcodeFlow::define(const GcodeFlowWord& word, GcodePlace next,
                                     GcodeParameters& parameters) {
  set_value(word, parameters);
  if (word.key == Key::endsub) {
    defined_.clear();
    return next;
  }
  const Result<Found> end = find(word, next, {Key::back, Key::endsub});
  return end ? Result<GcodePlace>(end->here) : end.error();
}

/// What endsub and return say; 0 if nothing.
void GcodeFlow::set_value(const GcodeFlowWord& word,
                          GcodeParameters& parameters) {
  const bool returns = !word.numbers.empty();
  parameters.assign({true, 0, "_VALUE", true},
                    {returns ? word.numbers[0] : 0, !returns || word.known});
  parameters.assign({true, 0, "_VALUE_RETURNED", true},
                    {returns ? 1.0 : 0.0, true});
}

void GcodeFlow::find_subs() {
  subs_found_ = true;
  visit_flow_lines(
      text_, {},
      [this](const GcodeFlowWord& word, GcodePlace, GcodePlace next) {
        if (word.key == Key::sub && word.label_known) {
          subs_.emplace(word.label, next);
        }
        return true;
      });
}

Result<GcodeFlow::Found> GcodeFlow::find(const GcodeFlowWord& word,
                                         GcodePlace from, Keys keys) {
  std::uint32_t purpose = 0;
  for (const Key key : keys) purpose |= 1U << static_cast<unsigned>(key);
  const auto known = found_.find({from.at, purpose});
  if (known != found_.end()) return known->second;
  bool is_found = false;
  bool may_be = false;  // a label that depends on parameters
  Found found;
  visit_flow_lines(
      text_, from,
      [&](const GcodeFlowWord& other, GcodePlace here, GcodePlace next) {
        const bool wanted =
            (purpose >> static_cast<unsigned>(other.key) & 1) != 0;
        may_be = wanted && !other.label_known;
        is_found = wanted && other.label == word.label && !may_be;
        if (is_found) found = {here, next};
        return !is_found && !may_be;
      });
  if (may_be) {
    return Error{ErrorCode::unsupported,
                 "a label of " + std::string(flow_key_name(*(keys.end() - 1))) +
                     " that depends on parameters"};
  }
  if (!is_found) return without(word, flow_key_name(*(keys.end() - 1)));
  found_.emplace(std::pair(from.at, purpose), found);
  return found;
}

void GcodeFlow::push(Key key, const GcodeFlowWord& word, GcodePlace here,
                     GcodePlace begin) {
  Open& open = open_.emplace_back();
  open.key = key;
  open.label = word.label;
  open.line = here.line;
  open.begin = begin;
}

GcodeFlow::Open* GcodeFlow::innermost(const std::string& label, Keys keys) {
  const std::size_t outer = calls_.empty() ? 0 : calls_.back().open;
  for (std::size_t i = open_.size(); i > outer; --i) {
    Open& open = open_[i - 1];
    if (open.label != label ||
        std::find(keys.begin(), keys.end(), open.key) == keys.end()) {
      continue;
    }
    open_.resize(i);
    return &open_.back();
  }
  return nullptr;
}

}  // namespace unstep
