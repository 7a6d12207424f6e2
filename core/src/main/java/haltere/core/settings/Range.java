package haltere.core.settings;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The valid range of a number in a settings record, both ends included. NaN is never valid.
 *
 * @since 0.1
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Range {
  /**
   * The smallest valid value.
   *
   * @return a number
   */
  double min();

  /**
   * The largest valid value.
   *
   * @return a number
   */
  double max();

  /**
   * Whether a slider should move in equal ratios rather than in equal steps.
   *
   * @return true for values that span several decades
   */
  boolean logarithmic() default false;
}
