/* Compiling regular expressions (POSIX regcomp): a parser by recursive descent. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "regular.h"

struct parser {
    struct __crs_regex *regex;
    const char *at;
    int flags, groups, depth, error;
};

static int choice(struct parser *parser);

static int fail(struct parser *parser, int error)
{
    if (!parser->error)
        parser->error = error;
    return 0;
}

static int make(struct parser *parser, enum kind kind, int left, int right, int value)
{
    struct __crs_regex *regex = parser->regex;
    struct node *larger;

    if (regex->nodes == regex->room) {
        larger = realloc(regex->node, 2 * (regex->room + 8) * sizeof *larger);
        if (larger == NULL)
            return fail(parser, REG_ESPACE);
        regex->node = larger;
        regex->room = 2 * (regex->room + 8);
    }
    regex->node[regex->nodes] = (struct node){kind, left, right, value, 1, 1};
    return regex->nodes++;
}

static int is_extended(const struct parser *parser)
{
    return parser->flags & REG_EXTENDED;
}

/* Whether an operator is here: a character, behind a backslash in basic expressions. */
static int sees(const struct parser *parser, char operator)
{
    if (is_extended(parser))
        return parser->at[0] == operator;
    return parser->at[0] == '\\' && parser->at[1] == operator;
}

static void skip(struct parser *parser)
{
    parser->at += is_extended(parser) ? 1 : 2;
}

static void add(unsigned char *set, int c, int flags)
{
    set[c / 8] |= 1 << c % 8;
    if (flags & REG_ICASE) {
        set[toupper(c) / 8] |= 1 << toupper(c) % 8;
        set[tolower(c) / 8] |= 1 << tolower(c) % 8;
    }
}

static int is_blank(int c)
{
    return c == ' ' || c == '\t';
}

static void add_class(struct parser *parser, unsigned char *set, const char *name, int size)
{
    static const struct { const char *name; int (*test)(int); } classes[] = {
        {"alnum", isalnum}, {"alpha", isalpha}, {"blank", is_blank}, {"cntrl", iscntrl},
        {"digit", isdigit}, {"graph", isgraph}, {"lower", islower}, {"print", isprint},
        {"punct", ispunct}, {"space", isspace}, {"upper", isupper}, {"xdigit", isxdigit},
    };
    unsigned int i;
    int c;

    for (i = 0; i < sizeof classes / sizeof *classes; i++)
        if (strncmp(classes[i].name, name, size) == 0 && classes[i].name[size] == 0) {
            for (c = 0; c < 256; c++)
                if (classes[i].test(c))
                    add(set, c, parser->flags);
            return;
        }
    fail(parser, REG_ECTYPE);
}

/* Reads the end of a range, which may be [.x.] or [=x=]. */
static int set_character(struct parser *parser)
{
    const char *at = parser->at;

    if (at[0] == '[' && (at[1] == '.' || at[1] == '=')) {
        if (at[2] == 0 || at[3] != at[1] || at[4] != ']')
            return fail(parser, REG_ECOLLATE);
        parser->at += 5;
        return (unsigned char)at[2];
    }
    parser->at++;
    return (unsigned char)*at;
}

/* Reads the set after a [. */
static int read_set(struct parser *parser)
{
    struct __crs_regex *regex = parser->regex;
    unsigned char (*larger)[32] = realloc(regex->set, (regex->sets + 1) * sizeof *larger), *set;
    int negated = *parser->at == '^', first = 1, from, to;

    if (larger == NULL)
        return fail(parser, REG_ESPACE);
    regex->set = larger;
    set = larger[regex->sets];
    memset(set, 0, sizeof *larger);
    parser->at += negated;
    for (; *parser->at != ']' || first; first = 0) {
        if (*parser->at == 0)
            return fail(parser, REG_EBRACK);
        if (parser->at[0] == '[' && parser->at[1] == ':') {
            const char *end = strstr(parser->at + 2, ":]");
            if (end == NULL)
                return fail(parser, REG_EBRACK);
            add_class(parser, set, parser->at + 2, end - parser->at - 2);
            parser->at = end + 2;
            continue;
        }
        from = to = set_character(parser);
        if (parser->at[0] == '-' && parser->at[1] != ']' && parser->at[1] != 0) {
            parser->at++;
            to = set_character(parser);
            if (to < from)
                return fail(parser, REG_ERANGE);
        }
        for (; from <= to; from++)
            add(set, from, parser->flags);
    }
    parser->at++;
    for (from = 0; negated && from < 32; from++)
        set[from] = ~set[from];
    if (negated && parser->flags & REG_NEWLINE)
        set['\n' / 8] &= ~(1 << '\n' % 8);
    return make(parser, SET, 0, 0, regex->sets++);
}

static int read_group(struct parser *parser)
{
    int number = ++parser->groups, inside;

    skip(parser);
    if (++parser->depth > 200)
        return fail(parser, REG_ESPACE);
    inside = choice(parser);
    parser->depth--;
    if (!sees(parser, ')'))
        return fail(parser, REG_EPAREN);
    skip(parser);
    return make(parser, GROUP, inside, 0, number);
}

static int read_escaped(struct parser *parser)
{
    int c = (unsigned char)parser->at[1];

    if (c == 0)
        return fail(parser, REG_EESCAPE);
    parser->at += 2;
    if (isdigit(c) && c != '0') {
        if (c - '0' > parser->groups)
            return fail(parser, REG_ESUBREG);
        return make(parser, BACK, 0, 0, c - '0');
    }
    return make(parser, CHARACTER, 0, 0, c);
}

/* Reads one item without what repeats it; first says whether it is the first of a sequence. */
static int read_atom(struct parser *parser, int first)
{
    int c = (unsigned char)*parser->at, extended = is_extended(parser);

    if (sees(parser, '('))
        return read_group(parser);
    if (extended && (c == '*' || c == '+' || c == '?' || c == '{'))
        return fail(parser, REG_BADRPT);
    if (c == '\\')
        return read_escaped(parser);
    parser->at++;
    if (c == '.')
        return make(parser, ANY, 0, 0, 0);
    if (c == '[')
        return read_set(parser);
    if (c == '^' && (extended || first))
        return make(parser, START, 0, 0, 0);
    if (c == '$' && (extended || *parser->at == 0 || sees(parser, ')') || sees(parser, '|')))
        return make(parser, END, 0, 0, 0);
    return make(parser, CHARACTER, 0, 0, c);
}

static int read_count(struct parser *parser)
{
    int value = 0;

    while (isdigit((unsigned char)*parser->at) && value <= 255)
        value = value * 10 + *parser->at++ - '0';
    return value;
}

/* Reads the bounds after a {. */
static void read_bounds(struct parser *parser, int *least, int *most)
{
    skip(parser);
    if (!isdigit((unsigned char)*parser->at))
        fail(parser, REG_BADBR);
    *least = *most = read_count(parser);
    if (*parser->at == ',') {
        parser->at++;
        *most = isdigit((unsigned char)*parser->at) ? read_count(parser) : UNLIMITED;
    }
    if (!sees(parser, '}'))
        fail(parser, *parser->at == 0 ? REG_EBRACE : REG_BADBR);
    else
        skip(parser);
    if (*most < *least || *least > 255 || (*most > 255 && *most != UNLIMITED))
        fail(parser, REG_BADBR);
}

/* Reads what repeats an item; returns 0 if there is nothing. */
static int read_repetition(struct parser *parser, int *least, int *most)
{
    *most = UNLIMITED;
    if (*parser->at == '*') {
        *least = 0;
        parser->at++;
    } else if (sees(parser, '+')) {
        *least = 1;
        skip(parser);
    } else if (sees(parser, '?')) {
        *least = 0;
        *most = 1;
        skip(parser);
    } else if (sees(parser, '{')) {
        read_bounds(parser, least, most);
    } else {
        return 0;
    }
    return 1;
}

static int sequence(struct parser *parser)
{
    int whole = make(parser, EMPTY, 0, 0, 0), first = 1, item, least, most;

    while (!parser->error && *parser->at != 0 && !sees(parser, '|') &&
           !(sees(parser, ')') && parser->depth > 0)) {
        item = !is_extended(parser) && first && *parser->at == '*'
                   ? make(parser, CHARACTER, 0, 0, (unsigned char)*parser->at++)
                   : read_atom(parser, first);
        first = parser->regex->node[item].kind == START && !is_extended(parser);
        while (!parser->error && read_repetition(parser, &least, &most)) {
            item = make(parser, REPEAT, item, 0, 0);
            parser->regex->node[item].least = least;
            parser->regex->node[item].most = most;
        }
        whole = make(parser, SEQUENCE, whole, item, 0);
    }
    return whole;
}

static int choice(struct parser *parser)
{
    int whole = sequence(parser);

    while (!parser->error && sees(parser, '|')) {
        skip(parser);
        whole = make(parser, CHOICE, whole, sequence(parser), 0);
    }
    return whole;
}

static void release(struct __crs_regex *program)
{
    if (program != NULL) {
        free(program->node);
        free(program->set);
        free(program);
    }
}

int regcomp(regex_t *regex, const char *pattern, int flags)
{
    struct parser parser = {calloc(1, sizeof *parser.regex), pattern, flags, 0, 0, 0};
    int root;

    regex->__program = parser.regex;
    regex->re_nsub = 0;
    if (parser.regex == NULL)
        return REG_ESPACE;
    root = choice(&parser);
    if (!parser.error && *parser.at != 0)
        fail(&parser, REG_EPAREN);
    parser.regex->flags = flags;
    parser.regex->root = root;
    regex->re_nsub = parser.groups;
    if (parser.error) {
        release(parser.regex);
        regex->__program = NULL;
    }
    return parser.error;
}

void regfree(regex_t *regex)
{
    release(regex->__program);
    regex->__program = NULL;
}

size_t regerror(int error, const regex_t *regex, char *text, size_t size)
{
    static const char *const messages[] = {
        "Success", "No match", "Invalid regular expression", "Invalid collation character",
        "Invalid character class name", "Trailing backslash", "Invalid back reference",
        "Unmatched [, [^, [:, [., or [=", "Unmatched ( or \\(", "Unmatched \\{",
        "Invalid content of \\{\\}", "Invalid range end", "Memory exhausted",
        "Invalid preceding regular expression",
    };
    const char *message = error >= 0 && error <= REG_BADRPT ? messages[error] : "Unknown error";
    size_t length = strlen(message), kept = length < size ? length : size - 1;

    (void)regex;
    if (size > 0) {
        memcpy(text, message, kept);
        text[kept] = 0;
    }
    return length + 1;
}
