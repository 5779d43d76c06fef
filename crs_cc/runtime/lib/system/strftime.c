/* Dates as text (C17 7.27.3.5), in the "C" locale. */
#include <stdio.h>
#include <string.h>
#include <time.h>

static const char *const days[] = {
    "Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday",
};
static const char *const months[] = {
    "January", "February", "March", "April", "May", "June", "July", "August", "September",
    "October", "November", "December",
};

/* The destination of the text; `room` counts down to the final null character. */
struct output {
    char *at;
    size_t room;
    int full;
};

static void put(struct output *output, const char *text, size_t size)
{
    if (size > output->room) {
        output->full = 1;
        return;
    }
    __builtin_memcpy(output->at, text, size);
    output->at += size;
    output->room -= size;
}

static void put_number(struct output *output, const char *form, long long value)
{
    char text[32];

    put(output, text, sprintf(text, form, value));
}

static void put_name(struct output *output, const char *const *names, int count, int which,
                     size_t most)
{
    const char *name = which >= 0 && which < count ? names[which] : "?";
    size_t size = strlen(name);

    put(output, name, size < most ? size : most);
}

static int is_leap(long long year)
{
    return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
}

/* Returns the week of ISO 8601, whose first one has the year's first Thursday, and its year. */
static int iso_week(const struct tm *date, long long *year)
{
    int from_monday = (date->tm_wday + 6) % 7, week;

    *year = 1900LL + date->tm_year;
    week = (date->tm_yday - from_monday + 10) / 7;
    if (week < 1) {
        int length = 365 + is_leap(--*year);
        week = (date->tm_yday + length - from_monday + 10) / 7;
    } else if (week == 53) {
        int days_left = 365 + is_leap(*year) - 1 - date->tm_yday;
        if (days_left < 3 - from_monday) {
            ++*year;
            week = 1;
        }
    }
    return week;
}

static void convert(struct output *output, int letter, const struct tm *date);

static void put_all(struct output *output, const char *format, const struct tm *date)
{
    for (; *format; format++) {
        if (*format != '%') {
            put(output, format, 1);
            continue;
        }
        format++;
        if (*format == 'E' || *format == 'O')
            format++;
        if (*format == 0) {
            put(output, "%", 1);
            return;
        }
        convert(output, *format, date);
    }
}

static void put_iso(struct output *output, int letter, const struct tm *date)
{
    long long year;
    int week = iso_week(date, &year);

    if (letter == 'V')
        put_number(output, "%02lld", week);
    else if (letter == 'G')
        put_number(output, "%lld", year);
    else
        put_number(output, "%02lld", (year % 100 + 100) % 100);
}

/* Numbers: each as the value and the form that it has. */
static void convert_number(struct output *output, int letter, const struct tm *date)
{
    long long year = 1900LL + date->tm_year;
    int hour = date->tm_hour % 12 == 0 ? 12 : date->tm_hour % 12;

    switch (letter) {
    case 'C': put_number(output, "%02lld", year / 100 - (year % 100 < 0)); break;
    case 'd': put_number(output, "%02lld", date->tm_mday); break;
    case 'e': put_number(output, "%2lld", date->tm_mday); break;
    case 'H': put_number(output, "%02lld", date->tm_hour); break;
    case 'I': put_number(output, "%02lld", hour); break;
    case 'j': put_number(output, "%03lld", date->tm_yday + 1); break;
    case 'k': put_number(output, "%2lld", date->tm_hour); break;
    case 'l': put_number(output, "%2lld", hour); break;
    case 'M': put_number(output, "%02lld", date->tm_min); break;
    case 'm': put_number(output, "%02lld", date->tm_mon + 1); break;
    case 'S': put_number(output, "%02lld", date->tm_sec); break;
    case 's': {
        struct tm copy = *date;
        put_number(output, "%lld", mktime(&copy));
        break;
    }
    case 'U': put_number(output, "%02lld", (date->tm_yday + 7 - date->tm_wday) / 7); break;
    case 'u': put_number(output, "%lld", date->tm_wday == 0 ? 7 : date->tm_wday); break;
    case 'W':
        put_number(output, "%02lld", (date->tm_yday + 7 - (date->tm_wday + 6) % 7) / 7);
        break;
    case 'w': put_number(output, "%lld", date->tm_wday); break;
    case 'Y': put_number(output, "%lld", year); break;
    case 'y': put_number(output, "%02lld", (year % 100 + 100) % 100); break;
    }
}

static void convert(struct output *output, int letter, const struct tm *date)
{
    char unknown[2] = {'%', (char)letter};

    switch (letter) {
    case '%': put(output, "%", 1); break;
    case 'A': put_name(output, days, 7, date->tm_wday, 20); break;
    case 'a': put_name(output, days, 7, date->tm_wday, 3); break;
    case 'B': put_name(output, months, 12, date->tm_mon, 20); break;
    case 'b': case 'h': put_name(output, months, 12, date->tm_mon, 3); break;
    case 'c': put_all(output, "%a %b %e %H:%M:%S %Y", date); break;
    case 'D': case 'x': put_all(output, "%m/%d/%y", date); break;
    case 'F': put_all(output, "%Y-%m-%d", date); break;
    case 'G': case 'g': case 'V': put_iso(output, letter, date); break;
    case 'n': put(output, "\n", 1); break;
    case 'P': put(output, date->tm_hour < 12 ? "am" : "pm", 2); break;
    case 'p': put(output, date->tm_hour < 12 ? "AM" : "PM", 2); break;
    case 'R': put_all(output, "%H:%M", date); break;
    case 'r': put_all(output, "%I:%M:%S %p", date); break;
    case 'T': case 'X': put_all(output, "%H:%M:%S", date); break;
    case 't': put(output, "\t", 1); break;
    case 'Z': put(output, "UTC", 3); break;
    case 'z': put(output, "+0000", 5); break;
    default:
        if (strchr("CdeHIjklMmSsUuWwYy", letter) != NULL)
            convert_number(output, letter, date);
        else
            put(output, unknown, 2);
    }
}

size_t strftime(char *text, size_t size, const char *format, const struct tm *date)
{
    struct output output = {text, size - 1, 0};

    if (size == 0)
        return 0;
    put_all(&output, format, date);
    if (output.full)
        return 0;
    *output.at = 0;
    return output.at - text;
}
