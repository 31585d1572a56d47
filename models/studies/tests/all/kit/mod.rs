mod page;
mod preview;
mod sheet;
