/** Outputs of lines over the network, found as services, and plots. */
package haltere.core.sink.internal;
