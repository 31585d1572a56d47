mod real;
mod surd;
