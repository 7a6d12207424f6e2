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
   * Digits after the decimal point of a floating-point number.
   *
   * @return 0 to 9, or -1 for as many as are needed to read the same number back
   */
  int decimals() default -1;

  /**
   * Whether the component is a record whose columns replace it.
   *
   * @return true for all of its columns except those whose component or column name exists before;
   *     a plain component after it takes the column of its name to its own position
   */
  boolean joined() default false;
}
