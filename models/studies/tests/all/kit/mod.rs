mod page;
mod picture;
mod sheet;
