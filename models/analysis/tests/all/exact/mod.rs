mod ball;
mod real;
mod surd;
