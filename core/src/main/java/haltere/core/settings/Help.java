package haltere.core.settings;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The effect of a setting in one sentence, for users.
 *
 * @since 0.1
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Help {
  /**
   * The sentence.
   *
   * @return ends with a full stop
   */
  String value();

  /**
   * Name of the setting for users, if the name of its component is not clear.
   *
   * @return a noun phrase, or empty for the component's name in words
   */
  String label() default "";
}
