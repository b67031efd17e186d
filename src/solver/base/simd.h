// Vector code that runs on any processor and uses what the present one has.
#pragma once

//! Before a function: compiles it for several generations of processors; the fitting one is chosen when the
//! program starts. All give the same bits, because nothing is contracted into fused operations. Elsewhere,
//! and under sanitizers (which cannot run before the choice), the function is compiled once.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__)
#define AUTOCUTS_CLONES __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define AUTOCUTS_CLONES
#endif
