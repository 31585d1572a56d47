mod decode;
mod golden;
mod sample;
