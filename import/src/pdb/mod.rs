//! Molecules: atoms of a structure file as spheres and cylinders.
