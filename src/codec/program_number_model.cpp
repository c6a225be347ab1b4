#include "codec/program_number_model.h"

#include "codec/context.h"

namespace unstep::codec {
namespace {

/// 1.4 / n for every input of a context, 12 fractional bits.
constexpr std::array<ProgramNumberModel::Decisions::Weights, 1> make_initial() {
  ProgramNumberModel::Decisions::Weights weights{};
  for (std::size_t i = 0; i < 2 * ProgramNumberModel::kContexts; ++i) {
    weights[i] = 4096 * 14 / 10 / ProgramNumberModel::kContexts;
  }
  return {weights};
}
constexpr auto kInitial = make_initial();

std::uint64_t distance_level(std::int64_t distance) {
  return signed_level(distance, 63);
}

/// Words whose numbers behave alike.
constexpr std::array<std::uint32_t, kProgramWords> kClasses{
    0, 0, 1, 2, 2, 2, 3, 3, 3, 4, 5, 5, 6, 6, 7, 7};

std::uint64_t word_of(std::int64_t value) {
  return static_cast<std::uint64_t>(value);
}

}  // namespace

ProgramNumberModel::ProgramNumberModel(int table_bits)
    : decisions_(table_bits, kInitial) {
  for (auto& word : errors_) word.fill(16 * 16);
}

std::size_t ProgramNumberModel::best(std::size_t word) const {
  const auto& errors = errors_[word];
  return static_cast<std::size_t>(
      std::min_element(errors.begin(), errors.end()) - errors.begin());
}

std::uint64_t ProgramNumberModel::outlook(
    std::size_t word, const ProgramPredictions& predictions) const {
  const std::size_t primary = best(word);
  return distance_level(predictions[primary]) * 64 +
         static_cast<std::uint64_t>(std::min(errors_[word][primary] / 8, 63));
}

void ProgramNumberModel::begin_number(const ProgramNumberPlace& place,
                                      const ProgramPredictions& predictions) {
  place_ = place;
  predictions_ = predictions;
  primary_ = best(place.word);
  word_class_ = kClasses[place.word];
  const auto error =
      static_cast<std::uint32_t>(errors_[place.word][primary_] / 16);
  second_selector_ = std::min(error, 15U) * 64 +
                     length_class(place.vectors) * 8 +
                     length_class(place.places);
}

void ProgramNumberModel::set_contexts(std::int64_t border,
                                      std::uint64_t prefix) {
  Decisions::Values values{};
  const auto& errors = errors_[place_.word];
  const std::int64_t base = predictions_[primary_];
  for (std::size_t k = 0; k < kProgramPredictors; ++k) {
    const auto error = static_cast<std::uint64_t>(errors[k] / 16);
    values[k] = mix(word_class_ << 8 | error,
                    distance_level(predictions_[k] - base - border));
  }
  const auto& residuals = residuals_[place_.word];
  const auto error = static_cast<std::uint64_t>(errors[primary_] / 8);
  std::size_t at = kProgramPredictors;
  values[at++] =
      mix(word_class_ << 8 | primary_ << 16 | error, std::min(prefix, 64UL));
  values[at++] = mix(mix(place_.word, distance_level(residuals[0])),
                     mix(distance_level(residuals[1]), std::min(prefix, 16UL)));
  values[at++] =
      mix(mix(word_of(predictions_[9] - base), std::min(place_.places, 15U)),
          mix(prefix, place_.word));
  values[at++] =
      mix(mix(word_of(place_.trail->moves[0]), word_of(place_.trail->moves[1])),
          mix(prefix, place_.word));
  values[at++] =
      mix(mix(distance_level(line_residual_), word_class_ << 8 | error),
          std::min(prefix, 16UL));
  decisions_.set_contexts(values);
}

void ProgramNumberModel::learn(std::int64_t value) {
  auto& errors = errors_[place_.word];
  for (std::size_t k = 0; k < kProgramPredictors; ++k) {
    const std::int64_t off = value - predictions_[k];
    const auto width = static_cast<std::int32_t>(
        std::bit_width(static_cast<std::uint64_t>(off < 0 ? -off : off)));
    errors[k] += (16 * width - errors[k]) / 4;
  }
  auto& residuals = residuals_[place_.word];
  residuals[1] = residuals[0];
  residuals[0] = value - predictions_[primary_];
  line_residual_ = residuals[0];
}

}  // namespace unstep::codec
