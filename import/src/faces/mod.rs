//! CAD faces: a face list compiled to quadrics and cut planes.
