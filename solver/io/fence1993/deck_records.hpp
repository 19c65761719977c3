#pragma once

#include "solver/base/error.hpp"
#include "solver/scenes/fence.hpp"

/// The records of a 1993 deck in their order (Mustoe & Huttelmaier 1993, Appendix II.4), defined once for the reader
/// and the writer. A `Deck` has the members
///
///   element(number)                      the following values belong to this element; 0: to the fence
///   record(names)                        a new record
///   real(name, owner, member)            a number in the deck's units
///   count(name, owner, member)           a whole number
///   pair(name, name, owner, member)      two numbers of a vector
///   code(name, field, value)             an enum by its number
///   held(axes)                           three flags
///   rocks(fence)                         nel, which gives the number of rocks
///   list(names, names, field, values)    a record with a count, then one with the values
///
/// The names are those of the manual.
namespace talus::deck_records {

template <class Deck, class Element>
void pass_element(Deck& deck, Element& e) {
  using E = scenes::FenceElement;
  deck.record("type, shape, points");
  deck.code("type", "type", e.type);
  deck.code("shape", "solid", e.solid);
  deck.count("points", e, &E::points);
  deck.record("xlen, ylen, power, rho, barlen");
  deck.real("xlen", e, &E::a);
  deck.real("ylen", e, &E::b);
  deck.real("power", e, &E::power);
  deck.real("rho", e, &E::density);
  deck.real("barlen", e, &E::bar_length);
  deck.record("xcent, ycent, theta, vx, vy, omega, fx, fy, mz");
  deck.pair("xcent", "ycent", e, &E::position);
  deck.real("theta", e, &E::angle);
  deck.pair("vx", "vy", e, &E::velocity);
  deck.real("omega", e, &E::spin);
  deck.pair("fx", "fy", e, &E::force);
  deck.real("mz", e, &E::moment);
  deck.record("bc(1), bc(2), bc(3), xfix, yfix");
  deck.held(e.held);
  deck.pair("xfix", "yfix", e, &E::fixed_point);
}

template <class Deck, class Fence>
void pass_control(Deck& deck, Fence& f) {
  using F = scenes::Fence;
  deck.record("fact_dt, niter, nprint, nhisto, f_penet");
  deck.real("fact_dt", f, &F::step_factor);
  deck.count("niter", f, &F::steps);
  deck.count("nprint", f, &F::print_every);
  deck.count("nhisto", f, &F::history_every);
  deck.real("f_penet", f, &F::penetration);
  deck.record("nel, igrav, grav");
  deck.rocks(f);
  deck.count("igrav", f, &F::gravity_sign);
  deck.real("grav", f, &F::gravity);
  deck.list("elstore", "elno", "history_elements", f.history_elements);
  deck.list("totvar", "variab", "history_codes", f.history_codes);
}

template <class Deck, class Fence>
void pass_layers(Deck& deck, Fence& f) {
  using F = scenes::Fence;
  deck.record(
      "span, sag, dcol, young, y_top, y_bot, nocab, ncol, ecoeff, area_top, area_bot, frict, slack, brek_top, "
      "brek_bot");
  deck.real("span", f, &F::span);
  deck.real("sag", f, &F::sag);
  deck.real("dcol", f, &F::spacing);
  deck.real("young", f, &F::young);
  deck.real("y_top", f, &F::y_top);
  deck.real("y_bot", f, &F::y_bottom);
  deck.count("nocab", f, &F::connections);
  deck.count("ncol", f, &F::columns);
  deck.real("ecoeff", f, &F::restitution);
  deck.real("area_top", f, &F::area_top);
  deck.real("area_bot", f, &F::area_bottom);
  deck.real("frict", f, &F::friction);
  deck.real("slack", f, &F::slack);
  deck.real("brek_top", f, &F::limit_top);
  deck.real("brek_bot", f, &F::limit_bottom);
  deck.record("no_fence, sp_fence");
  deck.count("no_fence", f, &F::layers);
  deck.real("sp_fence", f, &F::layer_spacing);
  deck.record("rf_overlap, ff_overlap");
  deck.real("rf_overlap", f, &F::rock_overlap);
  deck.real("ff_overlap", f, &F::layer_overlap);
}

/// All records after the title.
template <class Deck, class Fence>
void pass(Deck& deck, Fence& fence) {
  deck.element(0);
  pass_control(deck, fence);
  std::size_t number = 1;
  deck.element(number);
  pass_element(deck, fence.ground);
  for (auto& rock : fence.rocks) {
    deck.element(++number);
    pass_element(deck, rock);
  }
  deck.element(++number);
  pass_element(deck, fence.column);
  deck.element(0);
  pass_layers(deck, fence);
}

/// The entry for `member` in a table of fields.
template <class Table, class Member>
auto field_of(const Table& table, Member member) {
  for (const auto& field : table) {
    if (decltype(field.member){member} == field.member) return field;
  }
  TALUS_DEMAND(false);
}

}  // namespace talus::deck_records
