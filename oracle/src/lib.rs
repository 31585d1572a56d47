//! Checks of pictures that share no algorithm with the preparation or the golden model.
