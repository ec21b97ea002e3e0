#include "services/ordering/algo/tours/array_tour.h"

namespace slicefarm::ordering {

ArrayTour::ArrayTour(Tour tour) : order_(std::move(tour)), position_(order_.size()) {
  for (int32_t i = 0; i < size(); ++i) position_[static_cast<size_t>(At(i))] = i;
}

Reversal ArrayTour::Reverse(int32_t a, int32_t b) {
  Reversal turn{PositionOf(a), PositionOf(b)};
  if (2 * Length(turn, size()) > size()) {
    turn = {turn.to + 1 < size() ? turn.to + 1 : 0, turn.from > 0 ? turn.from - 1 : size() - 1};
  }
  Reverse(turn);
  return turn;
}

void ArrayTour::Reverse(Reversal turn) {
  int32_t i = turn.from;
  int32_t j = turn.to;
  for (int32_t left = Length(turn, size()) / 2; left > 0; --left) {
    const int32_t a = At(i);
    const int32_t b = At(j);
    order_[static_cast<size_t>(i)] = b;
    position_[static_cast<size_t>(b)] = i;
    order_[static_cast<size_t>(j)] = a;
    position_[static_cast<size_t>(a)] = j;
    if (++i == size()) i = 0;
    if (--j < 0) j = size() - 1;
  }
}

}  // namespace slicefarm::ordering
