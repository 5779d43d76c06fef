/* Keywords with their letters in a wrong order; the rest is understood. */
statci int total; // error: did you mean 'static'?
typdef int degrees; // error: did you mean 'typedef'?
struc turn { flaot rate; }; // error: did you mean 'struct'?
viod count(unsinged int n) // error: did you mean 'void'?
{
    whlie (n > 0) { // error: did you mean 'while'?
//  ^
        n--;
        if (n == 3) total++; esle total--; // error: did you mean 'else'?
        if (n == 4) {
            contineu; // error: did you mean 'continue'?
        } esle { // error: did you mean 'else'?
            total = 0;
        }
    }
    fro (n = 0; n < 3; n++) total++; // error: did you mean 'for'?
    swich (n) { // error: did you mean 'switch'?
    cas 1: // error: did you mean 'case'?
        braek; // error: did you mean 'break'?
    }
    do { n++; } whiel (n < 3); // error: did you mean 'while'?
}

int main(void)
{
    degrees angle = 0;
    duoble x = angle; // error: did you mean 'double'?
    count(3);
    retrun -1; // error: did you mean 'return'?
}
