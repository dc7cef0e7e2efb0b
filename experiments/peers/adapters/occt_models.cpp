// SPDX-License-Identifier: MIT
// The edges of STEP and IGES models by Open CASCADE, cut into Bezier curves by our own exact arithmetic.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <opencascade/BRep_Tool.hxx>
#include <opencascade/Geom_BSplineCurve.hxx>
#include <opencascade/Geom_BezierCurve.hxx>
#include <opencascade/Geom_Circle.hxx>
#include <opencascade/Geom_Ellipse.hxx>
#include <opencascade/Geom_Line.hxx>
#include <opencascade/Geom_TrimmedCurve.hxx>
#include <opencascade/IGESControl_Reader.hxx>
#include <opencascade/Interface_CheckIterator.hxx>
#include <opencascade/Interface_InterfaceModel.hxx>
#include <opencascade/Message.hxx>
#include <opencascade/Message_Messenger.hxx>
#include <opencascade/Precision.hxx>
#include <opencascade/STEPControl_Reader.hxx>
#include <opencascade/Standard_Failure.hxx>
#include <opencascade/TColStd_Array1OfReal.hxx>
#include <opencascade/TopExp.hxx>
#include <opencascade/TopTools_IndexedMapOfShape.hxx>
#include <opencascade/TopoDS.hxx>
#include <opencascade/TopoDS_Edge.hxx>
#include <opencascade/XSControl_TransferReader.hxx>
#include <opencascade/XSControl_WorkSession.hxx>

#include "experiments/peers/models.hpp"
#include "reference/companion/bspline_control_points.hpp"

namespace bezierbench::peers {
namespace {

using reference::ExactBsplineWeights;

void append(std::vector<double>& coordinates, const gp_Pnt& point) {
  coordinates.insert(coordinates.end(), {point.X(), point.Y(), point.Z()});
}

/// The segments of one edge on their way into the set.
class Edge {
 public:
  Edge(curves::CurveSet& set, std::string name, int number) : set_(set), name_(std::move(name)), number_(number) {}

  void add(int degree, std::span<const double> coordinates, std::span<const double> weights = {}) {
    const auto finite = [](double x) { return std::isfinite(x); };
    if (!std::ranges::all_of(coordinates, finite) || !std::ranges::all_of(weights, finite))
      throw curves::Unreadable(
          fmt::format("{}: edge {} is not in the range of doubles; scale the model", name_, number_));
    curves::require_room(set_, name_);
    const auto form = weights.empty() ? Form::bernstein : Form::rational;
    set_.add(fmt::format("{}:{}", number_, segment_), {form, 3, degree, coordinates, weights}, segment_ == 0);
    ++segment_;
  }

 private:
  curves::CurveSet& set_;
  std::string name_;
  int number_;
  int segment_ = 0;
};

/// A B-spline curve by all its knots: those of a periodic one and its poles repeat at the ends.
struct Bspline {
  int degree;
  std::vector<double> knots;
  std::vector<double> poles;    ///< point by point
  std::vector<double> weights;  ///< none of a polynomial curve

  [[nodiscard]] std::size_t count() const { return knots.size() - static_cast<std::size_t>(degree) - 1; }
};

std::vector<double> knots_of(const Geom_BSplineCurve& curve) {
  return {curve.KnotSequence().begin(), curve.KnotSequence().end()};
}

std::vector<double> knots_of(const Geom_BezierCurve& curve) {
  std::vector<double> knots(2 * static_cast<std::size_t>(curve.Degree()) + 2, 0.0);
  std::fill(knots.begin() + curve.Degree() + 1, knots.end(), 1.0);
  return knots;
}

template <class OcctCurve>
Bspline bspline_of(const OcctCurve& curve) {
  Bspline spline{curve.Degree(), knots_of(curve), {}, {}};
  for (std::size_t k = 0; k < spline.count(); ++k) {
    const int pole = 1 + static_cast<int>(k) % curve.NbPoles();
    append(spline.poles, curve.Pole(pole));
    spline.weights.push_back(curve.Weight(pole));
  }
  if (std::ranges::count(spline.weights, spline.weights.front()) == std::ssize(spline.weights)) spline.weights.clear();
  return spline;
}

/// The end of an edge: a knot where it is one except for what Open CASCADE calls confusion.
double snapped(const Bspline& spline, double t) {
  const auto distance = [t](double knot) { return std::abs(knot - t); };
  const double nearest = *std::ranges::min_element(spline.knots, {}, distance);
  return distance(nearest) <= Precision::PConfusion() ? nearest : t;
}

/// Control point k of the part of a span from `from` to `to` is the blossom at n - k times `from` and k times `to`.
void add_spans(const Bspline& spline, double first, double last, Edge& edge) {
  const auto n = static_cast<std::size_t>(spline.degree);
  first = snapped(spline, first);
  last = snapped(spline, last);
  for (std::size_t s = n; s < spline.count(); ++s) {
    const double from = std::max(first, spline.knots[s]);
    const double to = std::min(last, spline.knots[s + 1]);
    if (!(from < to)) continue;
    const auto poles = std::span(spline.poles).subspan(3 * (s - n), 3 * (n + 1));
    std::vector<double> coordinates;
    std::vector<double> weights;
    for (std::size_t k = 0; k <= n; ++k) {
      std::vector<double> arguments(n, to);
      std::fill_n(arguments.begin(), n - k, from);
      ExactBsplineWeights blossom(std::span(spline.knots).subspan(s - n + 1, 2 * n), arguments);
      if (!spline.weights.empty()) {
        const auto of_span = std::span(spline.weights).subspan(s - n, n + 1);
        weights.push_back(reference::round_to(reference::binary64, blossom.sum(1, of_span).coordinate(0)));
        blossom = blossom.with(of_span);
      }
      const auto point = blossom.sum(3, poles);
      for (int axis = 0; axis < 3; ++axis)
        coordinates.push_back(reference::round_to(reference::binary64, point.coordinate(axis)));
    }
    edge.add(spline.degree, coordinates, weights);
  }
}

/// The middle control point of an arc of angle 2h is at 1 / cos h times its middle from the centre, with weight cos h.
void add_arcs(const Geom_Conic& ellipse, double first, double last, Edge& edge) {
  constexpr double slack = 1e-9;  // angles in files are rounded: one beyond a quarter by less is a quarter
  const int pieces = std::max(1, static_cast<int>(std::ceil((last - first) / (std::numbers::pi / 2) - slack)));
  const auto angle = [&](double piece) { return first + (last - first) * (piece / pieces); };
  const double weight = std::cos((last - first) / pieces / 2);
  const gp_XYZ centre = ellipse.Location().XYZ();
  for (int piece = 0; piece < pieces; ++piece) {
    std::vector<double> coordinates;
    append(coordinates, ellipse.Value(angle(piece)));
    append(coordinates, centre + (ellipse.Value(angle(piece + 0.5)).XYZ() - centre) / weight);
    append(coordinates, ellipse.Value(angle(piece + 1)));
    edge.add(2, coordinates, std::array{1.0, weight, 1.0});
  }
}

/// Adds the part of the curve from `first` to `last`; says why not, or nothing.
std::string add_curve(Handle(Geom_Curve) curve, double first, double last, Edge& edge) {
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
  if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) return "edges without an end";
  if (!(first < last)) return "edges of length 0";
  if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve)) {
    const double period = spline->IsPeriodic() ? spline->Period() : 0;
    for (int turn = period > 0 ? -1 : 0; turn <= (period > 0 ? 1 : 0); ++turn)
      add_spans(bspline_of(*spline), first - turn * period, last - turn * period, edge);
  } else if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(curve)) {
    add_spans(bspline_of(*bezier), first, last, edge);
  } else if (curve->IsKind(STANDARD_TYPE(Geom_Circle)) || curve->IsKind(STANDARD_TYPE(Geom_Ellipse))) {
    add_arcs(*Handle(Geom_Conic)::DownCast(curve), first, last, edge);
  } else if (curve->IsKind(STANDARD_TYPE(Geom_Line))) {
    std::vector<double> ends;
    append(ends, curve->Value(first));
    append(ends, curve->Value(last));
    edge.add(1, ends);
  } else {
    return fmt::format("edges of the type {}", curve->DynamicType()->Name());
  }
  return {};
}

/// The curves of the roots of a file that a reader of Open CASCADE has read.
void add_edges(XSControl_Reader& reader, const std::string& path, const std::string& name, curves::Read& read) {
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.Model()->NbEntities() == 0)
    throw curves::Unreadable(fmt::format(
        "{}: Open CASCADE cannot read it; write it again, as STEP (AP203, AP214, AP242) or IGES 5.3", name));
  const int roots = reader.NbRootsForTransfer();
  if (const int transferred = reader.TransferRoots(); transferred < roots)
    read.left_out["roots that Open CASCADE does not transfer"] = static_cast<std::size_t>(roots - transferred);
  const auto count = [&read](Interface_CheckIterator checks, const char* why) {
    checks = checks.Extract(Interface_CheckFail);
    for (checks.Start(); checks.More(); checks.Next()) ++read.left_out[why];
  };
  count(reader.WS()->ModelCheckList(), "entities that Open CASCADE cannot read");
  count(reader.WS()->TransferReader()->LastCheckList(), "entities that Open CASCADE does not transfer");
  TopTools_IndexedMapOfShape edges;
  if (const auto shape = reader.OneShape(); !shape.IsNull()) TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int k = 1; k <= edges.Extent(); ++k) {
    const auto& edge = TopoDS::Edge(edges(k));
    double first = 0;
    double last = 0;
    const auto curve = BRep_Tool::Curve(edge, first, last);
    Edge to(read.set, name, k - 1);
    std::string why;
    if (BRep_Tool::Degenerated(edge))
      why = "edges of length 0";
    else
      why = curve.IsNull() ? "edges without a curve in space" : add_curve(curve, first, last, to);
    if (!why.empty()) ++read.left_out[why];
  }
}

}  // namespace

curves::Read read_model(const std::string& path, const std::string& name) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  std::string word;
  std::ifstream(path) >> word;
  curves::Read read;
  try {
    STEPControl_Reader step;
    IGESControl_Reader iges;
    add_edges(word.starts_with("ISO-10303-21") ? static_cast<XSControl_Reader&>(step) : iges, path, name, read);
  } catch (const Standard_Failure& failure) {
    throw curves::Unreadable(fmt::format("{}: Open CASCADE gives up ({}); write the model again without healing it",
                                         name, failure.DynamicType()->Name()));
  }
  return read;
}

}  // namespace bezierbench::peers
