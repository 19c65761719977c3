#pragma once

/// Defines the concept NAME<T>: the class T has a member called MEMBER, whatever it is: data, function, template or
/// type, public or not, declared or inherited. With it a concept refuses an optional member of the wrong form, which it
/// would otherwise take for a missing one. T must not be final.
///
/// The name of a member that two base classes have is ambiguous: the probe derives from T and from a class that has it.
#define TALUS_NAMED_MEMBER(NAME, MEMBER)  \
  struct NAME##Decoy {                    \
    int MEMBER;                           \
  };                                      \
  template <class T>                      \
  struct NAME##Probe : T, NAME##Decoy {}; \
  template <class T>                      \
  concept NAME = !requires {              \
    &NAME##Probe<T>::MEMBER;              \
  }
