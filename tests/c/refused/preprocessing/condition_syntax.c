/* Conditions that are no expressions. */
#if 1 +  // error: in '#if': the expression ends too early
#endif
#if (2  // error: in '#if': '(' has no ')'
#endif
#if "text"  // error: in '#if': a string cannot stand here in the expression
#endif
#if 1.5  // error: in '#if': '1.5' is not an integer
#endif

int main(void)
{
    return 0;
}
