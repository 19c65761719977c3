#pragma once

/// Defines the concept NAME<T>: the class T has a member called MEMBER of any kind: data, function, template or type,
/// public or not, declared or inherited. It allows a concept to reject an optional member of the wrong form, which
/// would otherwise be treated as missing. T must not be final.
///
/// The probe derives from T and from a class that has MEMBER: if T has it too, the name is ambiguous in the probe.
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
