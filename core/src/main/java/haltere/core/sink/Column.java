package haltere.core.sink;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The column of a record's component in a table.
 *
 * @since 0.1
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Column {
  /**
   * Name of the column.
   *
   * @return the name, or empty for the component's name in snake_case
   */
  String value() default "";

  /**
   * Digits behind the decimal point of a floating-point number.
   *
   * @return 0 to 9, or -1 for as many as it takes to read the same number back
   */
  int decimals() default -1;

  /**
   * Whether the component is a record whose columns stand in its place.
   *
   * @return true for all of its columns but those of components whose names, or whose columns,
   *     stand before already; a plain component behind it takes its column to its own place
   */
  boolean joined() default false;
}
