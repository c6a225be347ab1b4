// Turns unit steps (Freeman codes 0 to 7) into digital straight segments, and
// the segments back into the same steps.
#include <unstep/interpolate.h>
#include <unstep/reverse.h>

#include <cstdio>
#include <string_view>
#include <vector>

int main() {
  std::vector<unstep::Step> steps;
  for (const char code : std::string_view("0010010010001001001002212122121"))
    steps.push_back(static_cast<unstep::Step>(code - '0'));

  std::vector<unstep::DigitalSegment> segments;
  unstep::ExactReverse exact(unstep::Connectivity::eight);
  unstep::DigitalSegment segment;
  for (const unstep::Step step : steps)
    if (exact.push(step, segment) == unstep::Pushed::segment)
      segments.push_back(segment);
  if (exact.finish(segment)) segments.push_back(segment);

  for (const unstep::DigitalSegment& s : segments)
    std::printf("%u steps of %d and %d, slope %u/%u\n", s.n, s.s0, s.s1, s.a,
                s.w);

  std::vector<unstep::Step> drawn(steps.size());
  const auto count = unstep::interpolate(segments, drawn);
  const bool same = count && drawn == steps;
  std::printf("%zu steps, %s\n", drawn.size(),
              same ? "identical" : "different");
  return same ? 0 : 1;
}
