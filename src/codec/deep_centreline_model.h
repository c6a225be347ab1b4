#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/centreline_warm_start.h"
#include "codec/deep_model.h"
#include "codec/line_follower.h"

namespace unstep::codec {

/// Predicts which pixels around the head of a line are ink for the max effort:
/// the contexts of CentrelineModel and sixteen more, in a DeepModel.
class DeepCentrelineModel : public LineFollower<DeepCentrelineModel> {
 public:
  /// The planes and rulers must outlive the model; 2^table_bits slots per
  /// context.
  DeepCentrelineModel(const PixelPlanes& planes, const VertexRulers& rulers,
                      int table_bits, const centreline_warm::Table& start);

  /// Bytes that the constructor allocates.
  static std::uint64_t memory(int table_bits);

 private:
  friend LineFollower<DeepCentrelineModel>;
  static constexpr std::size_t kAll = LineFollower::kContexts + 15;
  static constexpr std::size_t kSets = 7;
  using Model = DeepModel<kAll, 0, kSets, 3, kNodes>;
  static const Model::Choice kSizes;
  static std::array<Model::Weights, kNodes> first_weights();

  void look(const Sight& sight);
  void ask(unsigned found);
  void ask_beside(Node first);
  void ask(std::size_t i, std::uint64_t value);
  template <class Coder>
  bool decide(Coder& coder, Node node, bool bit) {
    if (node == kMoreAside) ask_beside(last_);
    last_ = node;
    return model_.code(coder, bit, choice_ + node, node);
  }

  Model model_;
  Model::Choice choice_;
  Node last_ = kAhead;  ///< decided
  std::array<std::uint64_t, kAll> values_{};
};

}  // namespace unstep::codec
