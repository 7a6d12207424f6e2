/** Live results over ZeroMQ; a module of its own, so that nobody gets the library unasked. */
package haltere.zeromq;
