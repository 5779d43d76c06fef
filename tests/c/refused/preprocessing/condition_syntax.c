/* Conditions that are no expressions. */
#if 1 +  // error: in '#if': unexpected end of the expression
#endif
#if (2  // error: in '#if': missing ')' for '('
#endif
#if "text"  // error: in '#if': unexpected string in the expression
#endif
#if 1.5  // error: in '#if': '1.5' is not an integer
#endif

int main(void)
{
    return 0;
}
