//! imogene-synth
