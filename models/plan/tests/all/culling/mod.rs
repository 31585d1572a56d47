mod blocks;
mod precision;
